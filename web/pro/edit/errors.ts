// The errors of the document that is edited, at the elements that the page shows.
import { errorMarks as marksOf, noMarks, spotOf, type ErrorMarks } from "../../shared/edit/errorMarks";
import type { Tree } from "../../shared/edit/tree";
import type { ServerError } from "../../generated/messages";
import type { ModelTree } from "../../shared/model/modelTree";
import { selectionsOf } from "../../shared/model/identity";
import { useView, view } from "../client";
import { editedTree, editing, showTop, useEditing } from "./editing";

interface Made {
  readonly tree: Tree;
  readonly errors: readonly ServerError[];
  readonly model: ModelTree;
  readonly marks: ErrorMarks;
}
let last: Made | undefined;

/** Of the model that is shown: the same object as long as nothing of it changed. */
export function errorMarks(): ErrorMarks {
  const { session } = editing.get();
  const [tree, errors, model] = [session?.confirmed?.tree, session?.errors, editedTree()];
  if (tree === undefined || errors === undefined || errors.length === 0 || model === undefined) return noMarks;
  if (last?.tree !== tree || last.errors !== errors || last.model !== model) last = { tree, errors, model, marks: marksOf(tree, errors, model) };
  return last.marks;
}

/** How many errors a node or port has; of a node that is shown closed (`closed`), with all that is in it. None on the page of a run. */
export function useErrorCount(address: string, closed = false): number {
  const edited = useView((v) => v.page === "edit");
  return useEditing(() => {
    if (!edited) return 0;
    const { own, inside } = errorMarks();
    return (own.get(address) ?? 0) + (closed ? (inside.get(address) ?? 0) : 0);
  });
}

/** The same of all, by path or address; of a node without what is in it. None on the page of a run. */
export function useErrorCounts(): ErrorMarks["own"] {
  const edited = useView((v) => v.page === "edit");
  return useEditing(() => (edited ? errorMarks() : noMarks).own);
}

/** Shows the element that an error is about, and selects it. */
export function goToError(error: ServerError): void {
  const { session, top } = editing.get();
  const tree = session?.confirmed?.tree;
  if (tree === undefined) return;
  const spot = spotOf(tree, error);
  if (spot.top !== top) showTop(spot.top);
  const model = editedTree();
  const selection = model && selectionsOf(model).get(spot.id);
  if (selection !== undefined) view.dispatch({ type: "jump", selection });
}
