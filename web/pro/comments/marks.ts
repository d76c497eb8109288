// How many open comments nodes have on the page that edits a document.
import { commentMarks, noCommentMarks, type CommentMarks } from "../../shared/edit/comments/marks";
import type { ModelTree } from "../../shared/model/modelTree";
import { useView } from "../client";
import { editedTree, useEditing } from "../edit/editing";

/** Of a model that is drawn of the document; the same object as long as nothing of it changed. */
export const useCommentMarks = (model: ModelTree | undefined): CommentMarks =>
  useEditing(({ session }) => (session?.view === undefined || model === undefined ? noCommentMarks : commentMarks(session.view, model)));

/** Of a node; of one that is shown closed, with what is in it. None on the page of a run. */
export function useCommentCount(path: string, closed: boolean): number {
  const edited = useView((v) => v.page === "edit");
  return useEditing(({ session }) => {
    const model = edited ? editedTree() : undefined;
    if (session?.view === undefined || model === undefined) return 0;
    const { own, inside } = commentMarks(session.view, model);
    return (own.get(path) ?? 0) + (closed ? (inside.get(path) ?? 0) : 0);
  });
}
