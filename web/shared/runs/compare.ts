// Two runs compared: where they first did different things.
import type { RunComparison } from "../../generated/messages";
import { microStepText } from "../derivation/proof";
import type { Moment } from "../past/moment";

/** The server compares so many macro steps in an answer at most; so often it is asked to go on. */
const kMostAnswers = 50;

/** Asks until a difference is found, or the end of the runs, or enough was compared. */
export async function compareAll(ask: (from: number) => Promise<RunComparison>): Promise<RunComparison> {
  let found = await ask(1);
  for (let asked = 1; found.next !== undefined && asked < kMostAnswers; asked++) found = await ask(found.next);
  return found;
}

/** The moment before the first derivation that differs; nothing if none does. */
export const firstDifference = ({ step, micro = 0 }: RunComparison): Moment | undefined => (step === undefined ? undefined : { step, micro });

export function comparisonText({ same, step, micro, first, second, compared, next, steps }: RunComparison, runs: readonly [string, string]): string {
  if (step !== undefined && (first === null || second === null)) {
    const [shorter, longer] = first === null ? runs : [runs[1], runs[0]];
    return `The same up to macro step ${compared}, where run ${shorter} ends; run ${longer} goes on.`;
  }
  if (step !== undefined && micro === undefined) return `They first differ in macro step ${step}: its derivations are the same, what it calls or leaves is not.`;
  if (step !== undefined && micro !== undefined) return `They first differ in ${microStepText({ step, micro })}.`;
  if (next !== undefined) return `The same up to macro step ${compared}; further ones were not compared.`;
  return same ? `The same: derivations, calls and states of all ${steps[0]} macro steps.` : `The same up to macro step ${compared}.`;
}
