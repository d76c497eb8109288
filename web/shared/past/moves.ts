// Where a step back or forward leads, by micro steps or by macro steps.
import { assertNever } from "../assertNever";
import type { Past } from "../../generated/messages";
import type { Wanted } from "./moment";

export type Move = "back" | "forward" | "back_step" | "forward_step";

/** `present`: from the last moment, one comes to the run as it is now. */
export type Target = Wanted | "present";

const nextStep = (step: number, last: number, micro?: number): Target => {
  if (step >= last) return "present";
  return micro === undefined ? { step: step + 1 } : { step: step + 1, micro };
};

/** From a moment of a run of which `last` is the last macro step that has begun; nothing: it leads nowhere. */
export function moved(move: Move, { step, micro, complete }: Pick<Past, "step" | "micro" | "complete">, last: number): Target | undefined {
  const before = step > 1 ? { step: step - 1 } : undefined;
  switch (move) {
    case "back":
      return micro > 0 ? { step, micro: micro - 1 } : before;
    case "forward":
      return complete ? nextStep(step, last, 0) : { step, micro: micro + 1 };
    case "back_step":
      return before ?? (micro > 0 ? { step, micro: 0 } : undefined);
    case "forward_step":
      return complete ? nextStep(step, last) : { step };
    default:
      return assertNever(move);
  }
}
