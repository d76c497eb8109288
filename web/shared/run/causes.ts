// Why a run ended through a port of its root: the chain of ports that led there, from the root down to what came from outside.
import type { Input, TraceStep } from "../../generated/messages";
import { isLater, lastInference, type MicroStep } from "../derivation/proof";
import { portText } from "../model/describe";
import { portAt, splitAddress, type ModelTree } from "../model/modelTree";
import { portsRead } from "./portsRead";

/** A port that fired. */
export interface Cause {
  readonly address: string;
  /** Its condition, or time-out. */
  readonly condition: string;
  readonly firing: MicroStep;
  /** What arrived in the macro step in which it fired. */
  readonly input?: Input;
}

/** The child's port by which the condition of this one became true: of those that it names, the one that fired last, and before it. */
function childOf(tree: ModelTree, steps: readonly TraceStep[], address: string, condition: string, firing: MicroStep): string | undefined {
  const fired = portsRead(tree, splitAddress(address)?.path ?? "", condition).flatMap((from) => {
    const at = lastInference(steps, { port: from });
    return at === undefined || isLater(at, firing) ? [] : [{ from, at }];
  });
  return fired.sort((a, b) => (isLater(a.at, b.at) ? -1 : 1))[0]?.from;
}

/** The chain from the port at `address` on, as far as the derivations of its steps are among `steps`. */
export function causes(tree: ModelTree, steps: readonly TraceStep[], address: string): readonly Cause[] {
  const found: Cause[] = [];
  for (let next: string | undefined = address; next !== undefined; ) {
    const port = portAt(tree, next);
    const firing = lastInference(steps, { port: next });
    if (port === undefined || firing === undefined) break;
    const condition = portText(port);
    const input = steps.find(({ step }) => step === firing.step)?.input;
    found.push({ address: next, condition, firing, ...(input !== undefined && { input }) });
    next = childOf(tree, steps, next, condition, firing);
  }
  return found;
}
