// Why a run ended through a port of its root: the chain of ports that led there, from the root down to what came from outside.
import type { Input, TraceStep } from "../../generated/messages";
import { lastFiring, type MicroStep } from "../derivation/proof";
import { exitReferences } from "../model/exitReferences";
import { portText } from "../model/describe";
import { childPath } from "../model/model";
import { portAt, splitAddress, stateAt, type ModelTree } from "../model/modelTree";

/** A port that fired. */
export interface Cause {
  readonly address: string;
  /** Its condition, or time-out. */
  readonly condition: string;
  readonly firing: MicroStep;
  /** What arrived in the macro step in which it fired. */
  readonly input?: Input;
}

const isLater = (a: MicroStep, b: MicroStep): boolean => a.step > b.step || (a.step === b.step && a.micro > b.micro);

/** The child's port by which the condition of this one became true: of those that it names, the one that fired last, and before it. */
function childOf(tree: ModelTree, steps: readonly TraceStep[], address: string, condition: string, firing: MicroStep): string | undefined {
  const path = splitAddress(address)?.path ?? "";
  const children = stateAt(tree, path)?.children ?? [];
  const fired = exitReferences(condition).flatMap(({ child, port }) => {
    const node = children.find(({ name }) => name === child);
    const from = node === undefined ? undefined : `${childPath(path, node)}.${port}`;
    const at = from === undefined ? undefined : lastFiring(steps, from);
    return from === undefined || at === undefined || isLater(at, firing) ? [] : [{ from, at }];
  });
  return fired.sort((a, b) => (isLater(a.at, b.at) ? -1 : 1))[0]?.from;
}

/** The chain from the port at `address` on, as far as the derivations of its steps are among `steps`. */
export function causes(tree: ModelTree, steps: readonly TraceStep[], address: string): readonly Cause[] {
  const found: Cause[] = [];
  for (let next: string | undefined = address; next !== undefined; ) {
    const port = portAt(tree, next);
    const firing = lastFiring(steps, next);
    if (port === undefined || firing === undefined) break;
    const condition = portText(port);
    const input = steps.find(({ step }) => step === firing.step)?.input;
    found.push({ address: next, condition, firing, ...(input !== undefined && { input }) });
    next = childOf(tree, steps, next, condition, firing);
  }
  return found;
}
