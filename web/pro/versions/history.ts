// The history of the document that is edited: its revisions, what is compared (also in the address), restore and branch.
import { applyHistory, noHistory, type History, type HistoryEvent } from "../../shared/versions/history";
import { isSameRange, rangeText, readRange, type Range } from "../../shared/versions/range";
import { addressWith, placeOfAddress } from "../../shared/session/address";
import { api, loadDocuments, session } from "../client";
import { author } from "../edit/author";
import { editing, openDocument } from "../edit/editing";
import { refuse, tellDone } from "../edit/say";
import { whenStored } from "../edit/whenStored";
import { createStore, useSelected } from "../../page/store";
import { messageOf } from "../../shared/messageOf";

const store = createStore<History, HistoryEvent>(noHistory, applyHistory);

export const useHistory = <T>(select: (history: History) => T): T => useSelected(store, select);

/** In the address, a list of which nothing is compared. */
const kList = "list";

function toAddress(): void {
  const { shown, range } = store.get();
  history.replaceState(null, "", addressWith(location.search, { versions: shown ? (range === undefined ? kList : rangeText(range)) : undefined }));
}

/** Shows the list, or closes it. */
export function showHistory(shown: boolean): void {
  store.dispatch({ type: "show", shown });
  toAddress();
  if (shown) void loadNewest();
}

export const isHistoryShown = (): boolean => store.get().shown;

/** Compares two revisions, or one with the document as it is now. */
export function compareRange(range: Range | undefined): void {
  if (isSameRange(store.get().range, range)) return;
  store.dispatch({ type: "compare", range });
  toAddress();
}

async function load(before?: number): Promise<void> {
  const { document } = store.get();
  if (document === undefined) return;
  try {
    store.dispatch({ type: "loaded", page: await api.revisions(document, before) });
  } catch (error) {
    store.dispatch({ type: "failed", document, reason: messageOf(error) });
  }
}

export const loadNewest = (): Promise<void> => load();
export const loadOlder = (): Promise<void> => load(store.get().next);

/** While others type, the list is loaded again no more often than this [ms]. */
const kAgain = 1000;
let again: ReturnType<typeof setTimeout> | undefined;

/** The list has the revision that is here. */
function follow(): void {
  const { document, session: edited } = editing.get();
  if (store.get().document !== document) {
    store.dispatch({ type: "document", document });
    const { edit, versions } = placeOfAddress(location.search);
    const isThis = document !== undefined && edit === document && versions !== undefined;
    if (isThis) {
      store.dispatch({ type: "show", shown: true });
      store.dispatch({ type: "compare", range: readRange(versions) });
      void load();
    } else toAddress();
    return;
  }
  const [here, listed] = [edited?.confirmed?.revision, store.get().revisions[0]?.revision];
  if (!store.get().shown || here === undefined || listed === undefined || here <= listed) return;
  again ??= setTimeout(() => {
    again = undefined;
    void load();
  }, kAgain);
}

/** Follows the document that is open; to be called once, before the one that the address names is opened. */
export function followHistory(): void {
  editing.listen(follow);
  let connection = session.get().connection;
  session.listen(() => {
    const before = connection;
    connection = session.get().connection;
    if (before !== connection && connection === "open" && store.get().shown) void load();
  });
}

/** Makes an earlier revision the next one. */
export async function restore(revision: number): Promise<void> {
  const { document } = store.get();
  const stored = await whenStored();
  if ("reason" in stored) {
    refuse(stored.reason);
    return;
  }
  if (document === undefined || store.get().document !== document) return;
  try {
    const entry = await api.restoreDocument(document, revision, { onto: stored.revision, author: author() });
    const isNew = entry.revision > stored.revision;
    tellDone(isNew ? `Revision ${revision} is restored, as revision ${entry.revision}.` : `Revision ${revision} is the same as the last one: nothing had to be restored.`);
  } catch (error) {
    refuse(messageOf(error));
  }
}

/** Makes a revision the first one of a document of its own, and opens that. Throws what the server refuses. */
export async function branch(revision: number, as: string): Promise<void> {
  const { document } = store.get();
  if (document === undefined) return;
  await api.branchDocument(document, as, author(), revision);
  await loadDocuments();
  openDocument(as);
}
