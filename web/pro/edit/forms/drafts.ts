// The drafts of this page: kept in session storage, so that they outlive a reload, and followed until the server has answered.
import { applyDraftEvent, noDrafts, readDrafts, writeDrafts, type DraftEvent, type Drafts, type FieldPlace } from "../../../shared/edit/draftText";
import { reasonText } from "../../../shared/edit/refusalText";
import type { Change } from "../../../shared/edit/session";
import { refusalNow } from "../../login/rights";
import { createStore, useSelected } from "../../../page/store";
import { editing, perform } from "../editing";

const kKey = "race.drafts";

function stored(): Drafts {
  try {
    return readDrafts(sessionStorage.getItem(kKey) ?? "");
  } catch {
    return noDrafts;
  }
}

/** Where storage is refused, drafts last as long as the page. */
function store(kept: Drafts): void {
  try {
    if (kept.size === 0) sessionStorage.removeItem(kKey);
    else sessionStorage.setItem(kKey, writeDrafts(kept));
  } catch {
    // They stay in memory.
  }
}

export const drafts = createStore<Drafts, DraftEvent>(stored(), applyDraftEvent);
drafts.listen(() => store(drafts.get()));

export const useDrafts = <T>(select: (drafts: Drafts) => T): T => useSelected(drafts, select);

/** Drafts that are on their way, by the changes that carry them. */
const underWay = new Map<Change, FieldPlace>();

/** Sends the draft of a field as `change`; it stays a draft until the document has it, or with the reason why it has not. */
export function sendDraft(place: FieldPlace, change: Change): void {
  const reason = refusalNow("edit");
  if (reason !== undefined) {
    drafts.dispatch({ type: "not_sent", place, reason });
    return;
  }
  drafts.dispatch({ type: "sent", place });
  underWay.set(change, place);
  perform(change);
  queueMicrotask(settle);
}

function settle(): void {
  const { session, told, document } = editing.get();
  for (const [change, place] of underWay) {
    const isOpen = session !== undefined && document === place.document;
    if (isOpen && session.pending.some((edit) => edit.change === change)) continue;
    underWay.delete(change);
    const refused = told.find(({ notice }) => notice?.change === change)?.notice;
    if (refused !== undefined) drafts.dispatch({ type: "refused", place, reason: reasonText(refused) });
    else if (isOpen) drafts.dispatch({ type: "accepted", place });
    else drafts.dispatch({ type: "refused", place, reason: "the document was closed before the server had answered" });
  }
}
// A refusal is told after the session that goes without the edit.
editing.listen(() => queueMicrotask(settle));
