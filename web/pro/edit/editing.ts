// The document that the page edits: its session with the server, the model that is drawn of it, and its place in the address (`?edit=NAME`).
import { useMemo } from "react";
import { applyEditing, nothingEdited, topOf, type Editing, type EditingEvent } from "../../shared/edit/editing";
import { editedState } from "../../shared/edit/editedModel";
import { openEditor, type Editor } from "../../shared/edit/editor";
import type { Change, EditSession } from "../../shared/edit/session";
import type { AcceptedEdit } from "../../generated/messages";
import { runToTurnTo } from "../../shared/live/shownRun";
import type { Tree } from "../../shared/edit/tree";
import { buildTree, type ModelTree } from "../../shared/model/modelTree";
import type { State } from "../../shared/model/model";
import { addressWith, placeOfAddress } from "../../shared/session/address";
import type { StreamUpdate } from "../../shared/messages/stream";
import { watchedCore } from "../../shared/session/session";
import { listenToStream, problem, session, view, watch } from "../client";
import { counted } from "../../shared/counted";
import { createStore, useSelected } from "../../page/store";
import { listenToOwnName } from "../presence/ownName";
import { refusalNow } from "../login/rights";
import { author } from "./author";

export const editing = createStore<Editing, EditingEvent>(nothingEdited, applyEditing);

export const useEditing = <T>(select: (editing: Editing) => T): T => useSelected(editing, select);

interface Open {
  readonly editor: Editor;
  readonly end: () => void;
}
let open: Open | undefined;
listenToOwnName(() => open?.editor.rename(author()));

/** Is told each edit of somebody else, with the session before and after it. */
type OthersListener = (edit: AcceptedEdit, before: EditSession, after: EditSession) => void;
const othersListeners = new Set<OthersListener>();

/** From now on; the result ends that. */
export function listenToOthers(listener: OthersListener): () => void {
  othersListeners.add(listener);
  return () => othersListeners.delete(listener);
}

function tellOthers(update: StreamUpdate, before: EditSession, after: EditSession): void {
  if (update.type !== "document_edited" || update.edit.document !== before.document || update.edit.author === before.author) return;
  othersListeners.forEach((listener) => listener(update.edit, before, after));
}

let lastTree: { readonly state: State; readonly tree: ModelTree } | undefined;

/** The model that is shown: the same object as long as the state that is shown did not change. */
export function editedTree(): ModelTree | undefined {
  const now = editing.get();
  const [tree, top] = [now.session?.view, topOf(now)];
  if (tree === undefined || top === undefined) return undefined;
  const state = editedState(tree, top);
  if (lastTree?.state !== state) lastTree = { state, tree: buildTree(state) };
  return lastTree.tree;
}

/** The same, for components. */
export function useEditedTree(): ModelTree | undefined {
  const edited = useEditing((now) => now.session?.view);
  const top = useEditing(topOf);
  return useMemo(() => (edited === undefined || top === undefined ? undefined : editedTree()), [edited, top]);
}

/** The document with the edits of this page, as edits see it. */
export const editedDocument = (): Tree | undefined => editing.get().session?.view;

/** A message of the server is taken up now: others may edit faster than the page is drawn, so it is drawn once a frame. */
let arriving = false;

/** Takes up the next session. What the view says of elements stays with them while they are renamed and moved. */
function takeUp(next: EditSession): void {
  const before = editedTree();
  if (arriving) editing.dispatchInFrame(() => ({ type: "session", session: next }));
  else editing.dispatch({ type: "session", session: next });
  const after = editedTree();
  if (before === undefined || after === undefined || before === after) return;
  if (arriving) view.dispatchInFrame(() => ({ type: "carry", of: "document", before, after }));
  else view.dispatch({ type: "carry", of: "document", before, after });
}

function receive(update: StreamUpdate): void {
  if (open === undefined) return;
  const { editor } = open;
  const before = editor.session();
  arriving = true;
  try {
    editor.receive(update);
  } finally {
    arriving = false;
  }
  tellOthers(update, before, editor.session());
}

/** Opens a document for editing; the page shows it. */
export function openDocument(name: string): void {
  if (editing.get().document !== name) {
    if (!mayClose()) return;
    closeDocument();
    editing.dispatch({ type: "open", document: name });
    const { stream, end } = listenToStream({ update: receive, connection: (now) => open?.editor.connection(now) });
    const editor = openEditor(stream, session.get().connection, name, author(), {
      onSession: takeUp,
      onNotice: (notice) => editing.dispatch({ type: "notice", notice }),
    });
    open = { editor, end };
    view.dispatch({ type: "page", page: "edit" });
    view.dispatch({ type: "forget" });
    turnToRunOf(name);
  }
  view.dispatch({ type: "page", page: "edit" });
  // A further document is a page of its own; that the first one is shown has been written with the page.
  if (placeOfAddress(location.search).edit !== name) history.pushState(null, "", addressWith(location.search, { edit: name }));
}

/** A run of the document is shown with it. */
function turnToRunOf(name: string): void {
  const run = runToTurnTo(session.get().cores, watchedCore(session.get()), name);
  if (run !== undefined) watch(run.id);
}

/** Edits of this page that the server has not taken yet. */
const waitingEdits = (): number => open?.editor.session().pending.length ?? 0;

/** Whether the document can be closed and nothing is lost by that; says why not. */
export function mayClose(): boolean {
  const waiting = waitingEdits();
  if (waiting === 0 || session.get().connection !== "lost") return true;
  problem(`${editing.get().document} stays open: the server is lost, and has not taken ${counted(waiting, "edit")} of this page. To give them up, reload the page.`);
  return false;
}

/** The browser asks before it leaves edits that wait; to be called once. */
export function keepEdits(): void {
  addEventListener("beforeunload", (event) => waitingEdits() > 0 && event.preventDefault());
}

/** Leaves the document; edits that are on their way still arrive at the server. */
export function closeDocument(): void {
  if (open === undefined) return;
  open.editor.close();
  open.end();
  open = undefined;
  editing.dispatch({ type: "open", document: undefined });
  history.replaceState(null, "", addressWith(location.search, { edit: undefined }));
}

/** The document that the address names is opened; to be called once, when the page is connected. */
export function openFromAddress(): void {
  const { edit } = placeOfAddress(location.search);
  if (edit !== undefined) openDocument(edit);
}

/** Edits the document. The change is seen at once, or when the server has made it; a refusal is told (`told`). */
export function perform(change: Change): void {
  const reason = refusalNow("edit");
  if (reason === undefined) open?.editor.edit(change);
  else editing.dispatch({ type: "said", tone: "refused", text: `Not done: ${reason}.` });
}

/** Shows a state of the library as a whole, or the root. */
export function showTop(id: string | undefined): void {
  editing.dispatch({ type: "top", id });
  view.dispatch({ type: "forget" });
}
