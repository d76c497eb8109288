// Elements of a model that is drawn, between their addresses, which change with names and places, and their ids, which do not.
import { portAddress } from "./model";
import { portAt, splitAddress, type ModelTree } from "./modelTree";

/** A node by its path, or a port by its address. */
export type Selection = { readonly kind: "node"; readonly path: string } | { readonly kind: "port"; readonly address: string };

/** The id of what is selected; nothing if the model has no such element, or it has no id. */
export function idAt(tree: ModelTree, selection: Selection): string | undefined {
  return selection.kind === "node" ? tree.get(selection.path)?.node.id : portAt(tree, selection.address)?.id;
}

/** The state or barrier at this path, or that has the port of this address. */
export const ownerIdOf = (tree: ModelTree, selection: Selection): string | undefined =>
  tree.get(selection.kind === "node" ? selection.path : (splitAddress(selection.address)?.path ?? ""))?.node.id;

/** All nodes and ports by their ids. */
export type Selections = ReadonlyMap<string, Selection>;

const known = new WeakMap<ModelTree, Selections>();

/** Where every node and port of the model is; made once for a model. */
export function selectionsOf(tree: ModelTree): Selections {
  const before = known.get(tree);
  if (before !== undefined) return before;
  const found = new Map<string, Selection>();
  for (const { path, node } of tree.values()) {
    if (node.id !== undefined) found.set(node.id, { kind: "node", path });
    for (const port of node.kind === "state" ? node.ports : []) if (port.id !== undefined) found.set(port.id, { kind: "port", address: portAddress(path, port) });
  }
  known.set(tree, found);
  return found;
}

/** What is selected in `before`, in the model that it became; nothing if it is not there any more. */
export function carried(before: ModelTree, after: ModelTree, selection: Selection): Selection | undefined {
  const id = idAt(before, selection);
  return id === undefined ? undefined : selectionsOf(after).get(id);
}

/** The path of a node of `before` in `after`. */
export function carriedPath(before: ModelTree, after: ModelTree, path: string): string | undefined {
  const found = carried(before, after, { kind: "node", path });
  return found?.kind === "node" ? found.path : undefined;
}
