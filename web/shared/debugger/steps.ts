// Steps by states: into, over and out of one, and until one is reached.
import type { Selection } from "../model/identity";
import { portAt, stateAt, type ModelTree } from "../model/modelTree";
import { until, type UntilRequest } from "../run/controls";

export type StepWay = "into" | "over" | "out";
/** A step, or why there is none. */
export type StepOrReason = { readonly request: UntilRequest } | { readonly reason: string };

const depth = (path: string): number => path.split("/").length;

/** The state that steps are about: the selected one if it is active, else the innermost active one, of several the first. */
export function stepState(tree: ModelTree, active: readonly string[], selection: Selection | undefined): string | undefined {
  const states = active.filter((path) => stateAt(tree, path) !== undefined);
  if (selection?.kind === "node" && states.includes(selection.path)) return selection.path;
  return states.reduce<string | undefined>((best, path) => (best === undefined || depth(path) > depth(best) ? path : best), undefined);
}

export function stepBy(tree: ModelTree, active: readonly string[], selection: Selection | undefined, way: StepWay): StepOrReason {
  const path = stepState(tree, active, selection);
  const state = path === undefined ? undefined : stateAt(tree, path);
  if (path === undefined || state === undefined) return { reason: "no state is active" };
  // Between two of its states, what comes next is stepped to; over all of it only if it is selected.
  const isBetween = !(selection?.kind === "node" && selection.path === path) && (tree.get(path)?.children.length ?? 0) > 0;
  if (way !== "out") return { request: until(state, path, way === "into" || isBetween ? "into" : "left") };
  const parent = tree.get(path)?.parent;
  const around = parent === undefined ? undefined : stateAt(tree, parent);
  return parent === undefined || around === undefined ? { reason: "nothing is around the root" } : { request: until(around, parent, "left") };
}

/** Until what is selected is reached: a state is entered, a port fires. */
export function untilHere(tree: ModelTree, selection: Selection | undefined): StepOrReason {
  if (selection === undefined) return { reason: "nothing is selected" };
  if (selection.kind === "port") {
    const port = portAt(tree, selection.address);
    if (port === undefined) return { reason: "the run does not have it" };
    return { request: port.id === undefined ? { kind: "until", path: selection.address, when: "fired" } : { kind: "until", id: port.id, when: "fired" } };
  }
  const state = stateAt(tree, selection.path);
  return state === undefined ? { reason: "only states and ports are reached" } : { request: until(state, selection.path, "entered") };
}
