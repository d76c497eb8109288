// A field that is edited as a text: what it shows, and what its keys do. The text is a draft until it is committed, as one edit.
import { useEffect } from "react";
import { isUnsent, keyOfPlace, theirText, type FieldPlace } from "../../../shared/edit/draftText";
import type { Change } from "../../../shared/edit/session";
import { editing, useEditing } from "../editing";
import { drafts, sendDraft, useDrafts } from "./drafts";

/** What a text means; or why it means nothing. */
export type ChangeOf = (text: string) => Change | { readonly reason: string };

export interface DraftField {
  readonly text: string;
  readonly isDraft: boolean;
  /** Why it was refused. */
  readonly reason: string | undefined;
  /** What somebody else has written meanwhile. */
  readonly theirs: string | undefined;
  readonly type: (text: string) => void;
  /** Sends the draft; `again`: also if it was refused. Nothing happens to a text that somebody else has overtaken. */
  readonly commit: (again: boolean) => void;
  readonly giveUp: () => void;
  /** Replaces what somebody else has written. */
  readonly keep: () => void;
}

/** `now`: the text that the document has; nothing: it is not known for the moment, and nobody is taken to have overtaken the author. */
export function useDraft(id: string, field: string, now: string | undefined, changeOf: ChangeOf): DraftField {
  const document = useEditing((state) => state.document) ?? "";
  const place: FieldPlace = { document, id, field };
  const key = keyOfPlace(place);
  const draft = useDrafts((all) => all.get(key));
  const isDone = draft?.sent === undefined && draft?.text === now;
  useEffect(() => {
    if (isDone) drafts.dispatch({ type: "given_up", place: { document, id, field } });
  }, [isDone, document, id, field]);

  const commit = (again: boolean) => {
    const current = drafts.get().get(key);
    if (current === undefined || !isUnsent(current) || editing.get().session === undefined) return;
    if (theirText(current, now) !== undefined || (current.reason !== undefined && !again)) return;
    const change = changeOf(current.text);
    if ("reason" in change) drafts.dispatch({ type: "not_sent", place, reason: change.reason });
    else sendDraft(place, change);
  };
  return {
    text: draft?.text ?? now ?? "",
    isDraft: draft !== undefined && isUnsent(draft) && !isDone,
    reason: draft?.reason,
    theirs: draft && theirText(draft, now),
    type: (text) => drafts.dispatch({ type: "typed", place, text, now: now ?? draft?.base ?? "" }),
    commit,
    giveUp: () => drafts.dispatch({ type: "given_up", place }),
    keep: () => {
      if (now !== undefined) drafts.dispatch({ type: "kept", place, now });
      sendKept(place, changeOf);
    },
  };
}

function sendKept(place: FieldPlace, changeOf: ChangeOf): void {
  const kept = drafts.get().get(keyOfPlace(place));
  if (kept === undefined) return;
  const change = changeOf(kept.text);
  if ("reason" in change) drafts.dispatch({ type: "not_sent", place, reason: change.reason });
  else sendDraft(place, change);
}
