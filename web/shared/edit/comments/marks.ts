// How many open comments a model that is shown has where: at its nodes, by path.
import { selectionsOf } from "../../model/identity";
import { ancestry, type ModelTree } from "../../model/modelTree";
import type { Tree } from "../tree";
import { commentsOf, isOpen, type Comments } from "./comments";

export interface CommentMarks {
  /** Of a node itself. */
  readonly own: ReadonlyMap<string, number>;
  /** Of all that is in it. */
  readonly inside: ReadonlyMap<string, number>;
}

export const noCommentMarks: CommentMarks = { own: new Map(), inside: new Map() };

const known = new WeakMap<Comments, { readonly model: ModelTree; readonly marks: CommentMarks }>();

function count({ threads }: Comments, model: ModelTree): CommentMarks {
  const [own, inside] = [new Map<string, number>(), new Map<string, number>()];
  const selections = selectionsOf(model);
  const add = (counts: Map<string, number>, path: string) => counts.set(path, (counts.get(path) ?? 0) + 1);
  for (const thread of threads.filter(isOpen)) {
    const at = selections.get(thread.comment.about);
    if (at?.kind !== "node") continue;
    add(own, at.path);
    for (const above of ancestry(at.path).slice(0, -1)) add(inside, above);
  }
  return { own, inside };
}

/** The same object as long as the comments and the model are the same. */
export function commentMarks(tree: Tree, model: ModelTree): CommentMarks {
  const comments = commentsOf(tree);
  if (comments.threads.length === 0) return noCommentMarks;
  const before = known.get(comments);
  if (before?.model === model) return before.marks;
  const marks = count(comments, model);
  known.set(comments, { model, marks });
  return marks;
}
