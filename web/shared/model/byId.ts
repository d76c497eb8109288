// The elements of a model by their ids: what is kept about an element while the model is edited is kept by its id.
import type { Action, Barrier, Declaration, Parameter, Port, State } from "./model";
import type { ModelTree, TreeNode } from "./modelTree";

interface Kinds {
  readonly state: State;
  readonly barrier: Barrier;
  readonly port: Port;
  readonly parameter: Parameter;
  readonly result: Declaration;
  readonly variable: Declaration;
  readonly action: Action;
}

/** An element with the path of its node: of itself, if it is a state or barrier, else of the state that it belongs to. */
export type ModelElement = { readonly [K in keyof Kinds]: { readonly kind: K; readonly path: string; readonly element: Kinds[K] } }[keyof Kinds];

/** The elements that have an id. */
export type ElementsById = ReadonlyMap<string, ModelElement>;

function elementsOf({ path, node }: TreeNode): readonly ModelElement[] {
  if (node.kind === "barrier") return [{ kind: "barrier", path, element: node }];
  return [
    { kind: "state", path, element: node },
    ...node.parameters.map((element) => ({ kind: "parameter", path, element }) as const),
    ...node.results.map((element) => ({ kind: "result", path, element }) as const),
    ...node.variables.map((element) => ({ kind: "variable", path, element }) as const),
    ...node.actions.map((element) => ({ kind: "action", path, element }) as const),
    ...node.ports.map((element) => ({ kind: "port", path, element }) as const),
  ];
}

/** To be made once for a model. Of elements with the same id (not in what the store has given), the first in tree order is found. */
export function elementsById(tree: ModelTree): ElementsById {
  const found = new Map<string, ModelElement>();
  for (const element of [...tree.values()].flatMap(elementsOf)) {
    const { id } = element.element;
    if (id !== undefined && !found.has(id)) found.set(id, element);
  }
  return found;
}
