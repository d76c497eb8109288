// What a run has of an element now, found by the id of the element.
import type { RunState } from "../../generated/messages";
import type { JsonValue } from "../json";
import { elementsById, type ElementsById, type ModelElement } from "../model/byId";
import { portAddress } from "../model/model";
import type { ModelTree } from "../model/modelTree";

const known = new WeakMap<ModelTree, ElementsById>();

/** The element of the model of a run; nothing if it has none of this id. */
export function elementOfRun(tree: ModelTree, id: string): ModelElement | undefined {
  const before = known.get(tree);
  const all = before ?? elementsById(tree);
  if (before === undefined) known.set(tree, all);
  return all.get(id);
}

/** The value of a parameter, result or variable; nothing if it has none, or is something else. */
export function valueNow(tree: ModelTree, run: RunState, id: string): JsonValue | undefined {
  const found = elementOfRun(tree, id);
  switch (found?.kind) {
    case "parameter":
      return run.parameters[found.path]?.[found.element.name];
    case "result":
      return run.results[found.path]?.[found.element.name];
    case "variable":
      return run.variables[found.path]?.[found.element.name];
    default:
      return undefined;
  }
}

/** Whether the state that an element belongs to, or that it is, is active. */
export function isActiveNow(tree: ModelTree, run: RunState, id: string): boolean {
  const path = elementOfRun(tree, id)?.path;
  return path !== undefined && run.active.includes(path);
}

/** The address in the run of a port whose condition can be asked for: its state is active. */
export function askableAddress(tree: ModelTree, run: RunState, id: string): string | undefined {
  const found = elementOfRun(tree, id);
  return found?.kind === "port" && run.active.includes(found.path) ? portAddress(found.path, found.element) : undefined;
}
