// What actions act on: the document, what is selected in it, and the state whose inside is shown.
import type { Tree } from "../../shared/edit/tree";
import { idAt, ownerIdOf } from "../../shared/model/identity";
import type { ModelTree } from "../../shared/model/modelTree";
import { selectedPaths, type View } from "../../shared/session/view";
import { view } from "../client";
import { editedDocument, editedTree, editing } from "./editing";

export interface Situation {
  /** Its name. */
  readonly document: string;
  readonly tree: Tree;
  readonly model: ModelTree;
  readonly view: View;
  /** Ids of what is selected: nodes, the first of them first, or one port; none: nothing is. */
  readonly ids: readonly string[];
  /** The selected element if it is one alone. */
  readonly one: string | undefined;
  /** Of the selected elements, the state or barrier that is selected first, or that has the selected port. */
  readonly node: string | undefined;
  /** The state whose inside fills the canvas. */
  readonly focus: { readonly id: string; readonly path: string };
}

/** Nothing while no document is here. */
export function situationNow(): Situation | undefined {
  const { document } = editing.get();
  const [tree, model, now] = [editedDocument(), editedTree(), view.get()];
  if (document === undefined || tree === undefined || model === undefined) return undefined;
  const { selection } = now;
  const paths = selection?.kind === "port" ? [] : selectedPaths(now);
  const port = selection?.kind === "port" ? idAt(model, selection) : undefined;
  const ids = port !== undefined ? [port] : paths.map((path) => model.get(path)?.node.id).filter((id): id is string => id !== undefined);
  const shown = model.get(now.focus ?? "") ?? model.values().next().value;
  if (shown?.node.id === undefined) return undefined;
  return {
    document, tree, model, view: now, ids,
    one: ids.length === 1 ? ids[0] : undefined,
    node: selection && ownerIdOf(model, selection),
    focus: { id: shown.node.id, path: shown.path },
  };
}
