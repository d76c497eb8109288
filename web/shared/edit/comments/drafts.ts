// Where texts of comments are kept while they are written: drafts of fields of the element that they are about (edit/draftText.ts), each with
// the id that the comment has or will have, so that a comment that is sent and the next one are two.
import { isUnsent, type Drafts } from "../draftText";

const [kComment, kAnswer] = ["comment:", "answer:"];

/** Of a comment, new or not. */
export const commentField = (id: string): string => `${kComment}${id}`;
/** Of a new answer in the thread that begins with `first`. */
export const answerField = (first: string, id: string): string => `${kAnswer}${first}:${id}`;

export const isCommentField = (field: string): boolean => field.startsWith(kComment) || field.startsWith(kAnswer);

/** The ids of new comments on an element (`first` undefined) or answers that are written and not on their way, those begun first first. */
export function newOnes(drafts: Drafts, place: { readonly document: string; readonly id: string }, first: string | undefined, isThere: (comment: string) => boolean): readonly string[] {
  const prefix = first === undefined ? kComment : answerField(first, "");
  return [...drafts.values()].flatMap((draft) => {
    if (draft.document !== place.document || draft.id !== place.id || !draft.field.startsWith(prefix) || !isUnsent(draft)) return [];
    const id = draft.field.slice(prefix.length);
    return isThere(id) ? [] : [id];
  });
}
