// The model of the watched run, with the addresses that its state has.
import type { RcmDocument } from "../../shared/model/model";
import { modelShown } from "../../shared/past/shown";
import { buildTree, type ModelTree } from "../../shared/model/modelTree";
import { session, useSession } from "../client";

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
