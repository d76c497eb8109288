// What a run has of an element now, found by the id of the element.
import type { JsonValue } from "../json";
import { elementsById, type ElementsById, type ModelElement } from "../model/byId";
import type { Selection } from "../model/identity";
import { portAddress } from "../model/model";
import { stateAt, type ModelTree } from "../model/modelTree";
import type { LiveState } from "../run/liveState";
import type { Asked } from "../run/subject";

const known = new WeakMap<ModelTree, ElementsById>();

/** The element of the model of a run; nothing if it has none of this id. */
export function elementOfRun(tree: ModelTree, id: string): ModelElement | undefined {
  const before = known.get(tree);
  const all = before ?? elementsById(tree);
  if (before === undefined) known.set(tree, all);
  return all.get(id);
}

/** The value of a parameter, result or variable; nothing if it has none, or is something else. */
export function valueNow(tree: ModelTree, run: LiveState, id: string): JsonValue | undefined {
  const found = elementOfRun(tree, id);
  switch (found?.kind) {
    case "parameter":
      return run.parameters.get(found.path)?.[found.element.name];
    case "result":
      return run.results.get(found.path)?.[found.element.name];
    case "variable":
      return run.variables.get(found.path)?.[found.element.name];
    default:
      return undefined;
  }
}

/** Whether the state that an element belongs to, or that it is, is active. */
export function isActiveNow(tree: ModelTree, run: LiveState, id: string): boolean {
  const path = elementOfRun(tree, id)?.path;
  return path !== undefined && run.active.includes(path);
}

/** The address in the run of a port whose condition can be asked for: its state is active. */
export function askableAddress(tree: ModelTree, run: LiveState, id: string): string | undefined {
  const found = elementOfRun(tree, id);
  return found?.kind === "port" && run.active.includes(found.path) ? portAddress(found.path, found.element) : undefined;
}

/** Where the page of the run explains a port, an action or a parameter: what is selected there, and asked about. */
export interface Explained {
  readonly selection: Selection;
  readonly asked: Asked | undefined;
}

export function explainedAt(tree: ModelTree, id: string): Explained | undefined {
  const found = elementOfRun(tree, id);
  if (found?.kind === "port") return { selection: { kind: "port", address: portAddress(found.path, found.element) }, asked: undefined };
  if (found?.kind === "parameter") return { selection: { kind: "node", path: found.path }, asked: { parameter: found.element.name } };
  if (found?.kind !== "action") return undefined;
  const number = stateAt(tree, found.path)?.actions.indexOf(found.element) ?? -1;
  return number < 0 ? undefined : { selection: { kind: "node", path: found.path }, asked: { action: number } };
}
