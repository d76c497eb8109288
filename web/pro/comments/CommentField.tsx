// A text of a comment that is written: a draft until it is sent, by Ctrl+Enter or its button. Leaving the field keeps it.
import { useId, type KeyboardEvent } from "react";
import type { Command } from "../../shared/edit/commands/command";
import { kMaxText, type By } from "../../shared/edit/comments/write";
import type { Tree } from "../../shared/edit/tree";
import { FieldNotes } from "../edit/forms/FieldNotes";
import { useDraft } from "../edit/forms/useDraft";
import { useRefusal } from "../login/rights";
import { commandNow } from "./perform";

interface Props {
  /** The element that it is about, and the field of the draft. */
  readonly id: string;
  readonly field: string;
  readonly label: string;
  /** On the button. */
  readonly send: string;
  readonly placeholder?: string;
  /** What the document has. */
  readonly now: string;
  readonly make: (text: string, tree: Tree, by: By) => Command;
  readonly autoFocus?: boolean;
  /** It was sent, or given up. */
  readonly onEnd?: () => void;
}

export function CommentField({ id, field, label, send, placeholder, now, make, autoFocus = false, onEnd }: Props) {
  const unique = useId();
  const refusal = useRefusal("edit");
  const draft = useDraft(id, field, now, (text) => {
    const command = commandNow((tree, by) => make(text, tree, by));
    return "reason" in command ? command : command.change;
  });
  const commit = () => {
    if (draft.isDraft) draft.commit(true);
    onEnd?.();
  };
  const press = (event: KeyboardEvent) => {
    if (event.nativeEvent.isComposing) return;
    if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    event.stopPropagation();
    commit();
  };
  const isUsed = draft.isDraft || onEnd !== undefined;
  return (
    <div className={`form-field comment-field${draft.isDraft ? " is-draft" : ""}`}>
      <textarea
        aria-label={label}
        aria-describedby={`${unique}-notes`}
        aria-invalid={draft.reason !== undefined}
        data-place={`${id}/${field}`}
        placeholder={placeholder}
        readOnly={refusal !== undefined}
        title={refusal}
        value={draft.text}
        rows={1}
        maxLength={kMaxText}
        autoFocus={autoFocus}
        onChange={(event) => draft.type(event.target.value)}
        onKeyDown={press}
      />
      <FieldNotes id={id} field={field} noteId={`${unique}-notes`} draft={draft} />
      {isUsed && (
        <span className="field-choices">
          <button type="button" title="Ctrl+Enter" disabled={!draft.isDraft} onClick={commit}>
            {send}
          </button>
          <button
            type="button"
            onClick={() => {
              draft.giveUp();
              onEnd?.();
            }}
          >
            Discard
          </button>
        </span>
      )}
    </div>
  );
}
