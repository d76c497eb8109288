// In the header of the document: the texts that were written and are not in it. A click goes to the field.
import { useMemo, useRef } from "react";
import { draftsOf, isUnsent, type DraftText } from "../../../shared/edit/draftText";
import { nameOfElement } from "../../../shared/edit/commands/command";
import { isCommentField } from "../../../shared/edit/comments/drafts";
import { copyWritten } from "../copyWritten";
import { editedDocument, useEditing } from "../editing";
import { goToField } from "../goToField";
import { drafts, useDrafts } from "./drafts";
import { counted } from "../../../shared/counted";

function whereOf({ id, field: key }: DraftText): string {
  const tree = editedDocument();
  const field = isCommentField(key) ? "comment" : key;
  if (id === "") return `document, ${field}`;
  if (tree?.elements.has(id) !== true) return `an element that is gone, ${field}`;
  const { parent } = tree.elements.get(id) ?? { parent: "" };
  const owner = parent === "" ? "" : `${nameOfElement(tree, parent)} › `;
  return `${owner}${nameOfElement(tree, id)} › ${field}`;
}

export function DraftList() {
  const document = useEditing((state) => state.document) ?? "";
  const all = useDrafts((kept) => kept);
  const unsent = useMemo(() => draftsOf(all, document).filter(isUnsent), [all, document]);
  const menu = useRef<HTMLDetailsElement>(null);
  if (unsent.length === 0) return null;
  const go = (draft: DraftText) => {
    if (menu.current !== null) menu.current.open = false;
    goToField(draft.id, [draft.field]);
  };
  return (
    <details className="draft-list" ref={menu}>
      <summary>{counted(unsent.length, "unsent text")}</summary>
      <ul>
        {unsent.map((draft) => (
          <li key={`${draft.id}/${draft.field}`}>
            <button type="button" className="link" onClick={() => go(draft)}>
              {whereOf(draft)}
            </button>
            <code>{draft.text}</code>
            {draft.reason !== undefined && <span className="field-reason">{draft.reason}</span>}
            <button type="button" aria-label={`Copy ${whereOf(draft)}`} onClick={() => copyWritten(draft.text)}>
              Copy
            </button>
            <button type="button" aria-label={`Discard ${whereOf(draft)}`} title="Discard this text" onClick={() => drafts.dispatch({ type: "given_up", place: draft })}>
              ✕
            </button>
          </li>
        ))}
      </ul>
    </details>
  );
}
