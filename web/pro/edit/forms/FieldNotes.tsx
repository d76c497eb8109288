// Below a field: what the server finds wrong with it, why its draft was refused, and what somebody else has written meanwhile.
import { messageAtField } from "../../../shared/edit/places";
import { useFieldErrors } from "./useFieldErrors";
import { ConflictNote } from "../ConflictChoices";
import { useConflictAt } from "../conflicts";
import type { DraftField } from "./useDraft";
import { nameOfAuthor } from "../../../shared/presence/names";
import { lastAuthor } from "./useAuthors";

interface Props {
  readonly id: string;
  readonly field: string;
  /** Of the element that describes the field. */
  readonly noteId: string;
  readonly draft: DraftField;
}

/** A text in one line, cut. */
const kMost = 120;
const excerpt = (text: string): string => (text === "" ? "nothing" : text.length > kMost ? `${text.slice(0, kMost)}…` : text);

export function FieldNotes({ id, field, noteId, draft }: Props) {
  const errors = useFieldErrors(id, field);
  const { reason, theirs } = draft;
  const conflict = useConflictAt(id, field);
  if (errors.length === 0 && reason === undefined && theirs === undefined && conflict === undefined) return null;
  return (
    <div className="field-notes" id={noteId}>
      <ConflictNote id={id} field={field} />
      {theirs !== undefined && (
        <div className="field-theirs" role="alert">
          <span>
            {nameOfAuthor(lastAuthor(id, field)) || "Somebody"} changed this to <code>{excerpt(theirs)}</code>
          </span>
          <span className="field-choices">
            <button type="button" onClick={draft.giveUp}>
              Take theirs
            </button>
            <button type="button" onClick={draft.keep}>
              Keep mine
            </button>
          </span>
        </div>
      )}
      {reason !== undefined && (
        <p className="field-reason" role="alert">
          Not in the document: {reason}
        </p>
      )}
      {errors.map((error, i) => (
        <p key={i} className="field-error">
          {messageAtField(error)}
        </p>
      ))}
    </div>
  );
}
