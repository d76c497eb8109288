// What others do to what the person at this page has written: a field that both have set, and states that are deleted while one writes in them. It is
// told above the drawing and at the field, until its reader has chosen.
import { placeText, shownValue } from "../../shared/edit/changeText";
import { conflictsWith, isField, ownSets, type Conflict, type OwnSet } from "../../shared/edit/conflicts";
import { elementText } from "../../shared/edit/difference/rows";
import { draftsOf, isUnsent } from "../../shared/edit/draftText";
import type { Told } from "../../shared/edit/editing";
import type { EditSession } from "../../shared/edit/session";
import type { Tree } from "../../shared/edit/tree";
import { nameOfAuthor } from "../../shared/presence/names";
import { editing, listenToOthers, perform, useEditing } from "./editing";
import { drafts } from "./forms/drafts";

let own: readonly OwnSet[] = [];
let ownOf: string | undefined;

function noteOwn(): void {
  const { session, document } = editing.get();
  if (document !== ownOf) [own, ownOf] = [[], document];
  if (session !== undefined) own = ownSets(own, session, performance.now());
}

const textOf = (tree: Tree, conflict: Conflict): string =>
  `${nameOfAuthor(conflict.author)} has set ${placeText(tree, conflict)} to ${shownValue(conflict.theirs)}. Yours: ${shownValue(conflict.mine)}.`;

/** The states or barriers that have gone with an edit, of those in which somebody writes here; each with how many texts. */
function writtenIn(document: string, before: Tree, after: Tree): ReadonlyMap<string, number> {
  const found = new Map<string, number>();
  for (const { id } of draftsOf(drafts.get(), document).filter(isUnsent)) {
    const element = before.elements.get(id);
    if (element === undefined || after.elements.has(id)) continue;
    const owner = element.kind === "state" || element.kind === "barrier" ? id : element.parent;
    found.set(owner, (found.get(owner) ?? 0) + 1);
  }
  return found;
}

function tellDeleted(author: string, before: EditSession, after: EditSession): void {
  if (before.view === undefined || after.view === undefined) return;
  for (const [id, count] of writtenIn(after.document, before.view, after.view)) {
    const kept = count === 1 ? "Your text is kept: it is among the unsent texts" : `Your ${count} texts are kept: they are among the unsent ones`;
    editing.dispatch({ type: "said", tone: "met", text: `${nameOfAuthor(author)} has deleted ${elementText(before.view, id)}, in which you were writing. ${kept}, and back in its field when the deletion is undone.` });
  }
}

editing.listen(noteOwn);
listenToOthers((edit, before, after) => {
  noteOwn();
  const met = conflictsWith(own, edit);
  if (after.view !== undefined) for (const conflict of met) editing.dispatch({ type: "met", text: textOf(after.view, conflict), conflict });
  if (edit.operations.some(({ op }) => op === "remove")) tellDeleted(edit.author, before, after);
});

/** The conflict about a field of a form, if there is one. */
export const useConflictAt = (id: string, field: string): Told | undefined => useEditing(({ told }) => told.find(({ conflict }) => conflict !== undefined && isField(conflict, id, field)));

/** Its reader has seen it. */
export const settle = (number: number): void => editing.dispatch({ type: "seen", number });

/** Makes what was told about good by this change, and it is seen. */
export function settleBy(number: number, change: Parameters<typeof perform>[0]): void {
  settle(number);
  perform({ ...change });
}
