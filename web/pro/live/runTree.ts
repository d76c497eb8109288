// The model of the watched run, with the addresses that its state has.
import type { RcmDocument } from "../../shared/model/model";
import { modelShown } from "../../shared/past/shown";
import { buildTree, type ModelTree } from "../../shared/model/modelTree";
import { session, useSession, view } from "../client";

const trees = new WeakMap<RcmDocument, ModelTree>();

function treeOf(model: RcmDocument | undefined): ModelTree | undefined {
  if (model === undefined) return undefined;
  const known = trees.get(model);
  const tree = known ?? buildTree(model.root);
  if (known === undefined) trees.set(model, tree);
  return tree;
}

/** The same object as long as the model is. */
export const runTree = (): ModelTree | undefined => treeOf(modelShown(session.get()));

/** The same, for components. */
export const useRunTree = (): ModelTree | undefined => useSession((now) => treeOf(modelShown(now)));

/** What the view says of elements of a run stays with them while an edit, or a moment before it, has them elsewhere or not at all; to be called once. */
export function carryPlaces(): void {
  let [run, before] = [session.get().watched, runTree()];
  session.listen(() => {
    const { watched } = session.get();
    const after = runTree();
    if (watched === run && after === before) return;
    if (watched === run && before !== undefined && after !== undefined) view.dispatch({ type: "carry", of: "run", before, after });
    if (watched !== run || after !== undefined) [run, before] = [watched, after];
  });
}
