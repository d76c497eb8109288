// The application that is open: its document, edited through the same session as on the expert page, and what is told of it.
import { createStore, useSelected } from "../page/store";
import { openEditor, type Editor } from "../shared/edit/editor";
import type { Command } from "../shared/edit/commands/command";
import { refusalText } from "../shared/edit/refusalText";
import { readExact, type ExactJson } from "../shared/edit/exact";
import type { EditSession, Notice } from "../shared/edit/session";
import type { Tree } from "../shared/edit/tree";
import { newId } from "../shared/newId";
import { madeDocuments } from "../shared/skills/serviceSkills";
import type { Supplies } from "../shared/timeline/changes/draft";
import { api, listenToStream, refusalNow, session, watchApplication } from "./client";
import { author } from "./own";
import { skillDocuments } from "./skills";
import { texts } from "./texts";
import { refusedEdit, type RefusedEdit } from "./unsaved";

interface Editing {
  readonly document: string | undefined;
  readonly session: EditSession | undefined;
  /** Why the last change was not made; or what was done. */
  readonly told: { readonly text: string; readonly isRefusal: boolean } | undefined;
  /** Edits that waited for the server, and that it has refused: until a person has closed what is told of it, or makes another change. */
  readonly refused: readonly RefusedEdit[];
}

const kNothing: Editing = { document: undefined, session: undefined, told: undefined, refused: [] };
const store = createStore<Editing, Partial<Editing>>(kNothing, (now, change) => ({ ...now, ...change }));
export const useEditing = <T>(select: (editing: Editing) => T): T => useSelected(store, select);
export const useTree = (): Tree | undefined => useEditing((now) => now.session?.view);
export const treeNow = (): Tree | undefined => store.get().session?.view;

export const editingNow = (): Editing => store.get();
export const toldNow = (): string | undefined => store.get().told?.text;

/** Until this holds [ms]. */
const kPatience = 15_000;

/** When this holds of what is edited; rejects if it takes long. */
export function untilEditing(holds: (editing: Editing) => boolean): Promise<void> {
  return new Promise((resolve, reject) => {
    const end = (act: () => void) => {
      clearTimeout(late);
      ended();
      act();
    };
    const look = () => holds(store.get()) && end(resolve);
    const late = setTimeout(() => end(() => reject(new Error(texts.frame.noAnswer))), kPatience);
    const ended = store.listen(look);
    look();
  });
}

/** Nothing: a person has seen it. */
export const tell = (text: string | undefined, isRefusal = true): void => store.dispatch(text === undefined ? { told: undefined, refused: [] } : { told: { text, isRefusal } });

let open: { readonly editor: Editor; readonly end: () => void } | undefined;

/** A server that is there has an edit after this time, and if not, it is slow [ms]. */
const kUsual = 1000;
/** Since when edits have been waiting for the server [ms of performance.now()]. */
let waitingSince: number | undefined;

/** The session before the last step of it. */
let earlier: EditSession | undefined;

function takeUp(next: EditSession): void {
  earlier = store.get().session;
  waitingSince = next.pending.length === 0 ? undefined : (waitingSince ?? performance.now());
  store.dispatch({ session: next });
}

/** What was shown as done is not: it is told here, and once more when the application is left. */
function refuse(notice: Notice): void {
  tell(refusalText(notice));
  const waited = earlier?.pending.some(({ request }) => request === notice.request) === true;
  if (waited) store.dispatch({ refused: [...store.get().refused, refusedEdit(earlier?.view, notice)] });
}

/** Nothing is lost if the application is left now, and nothing was refused. Edits wait for a server that is not there, or late; others are on their way, and arrive. */
export function isAllSaved(): boolean {
  const { refused, session: now } = store.get();
  const isLate = waitingSince !== undefined && performance.now() - waitingSince > kUsual;
  return refused.length === 0 && (now?.pending.length === 0 || now === undefined || (!isLate && session.get().connection === "open"));
}

export function openApplication(name: string | undefined): void {
  open?.editor.close();
  open?.end();
  open = undefined;
  waitingSince = earlier = undefined;
  store.dispatch({ ...kNothing, document: name });
  watchApplication(name);
  if (name === undefined) return;
  const { stream, end } = listenToStream({ update: (update) => open?.editor.receive(update), connection: (now) => open?.editor.connection(now) });
  const editor = openEditor(stream, session.get().connection, name, author(), {
    onSession: takeUp,
    onNotice: refuse,
  });
  open = { editor, end };
  store.dispatch({ session: editor.session() });
}

/** Leaving the page would lose what the server has not taken yet. */
addEventListener("beforeunload", (event) => {
  if ((store.get().session?.pending.length ?? 0) > 0) event.preventDefault();
});

/** Makes a change of the document as it is now. The id of what is to be selected then; nothing: it was refused, and that is told. */
export function perform(make: (tree: Tree, supplies: Supplies) => Command): string | undefined {
  const tree = treeNow();
  const refusal = refusalNow("edit");
  if (tree === undefined || open === undefined) return undefined;
  const command = refusal === undefined ? make(tree, { newId, documents: [...skillDocuments(), ...madeDocuments(session.get().services)] }) : { reason: refusal };
  if ("reason" in command) {
    tell(texts.frame.notDone(command.reason));
    return undefined;
  }
  tell(undefined);
  open.editor.rename(author());
  open.editor.edit(command.change);
  return command.select ?? "";
}

export function takeBack(which: "undo" | "redo"): void {
  tell(undefined);
  open?.editor.edit(which === "undo" ? { undo: true } : { redo: true });
}

/** The document as the server has written it. */
export async function exactDocument(): Promise<ExactJson> {
  const { document } = store.get();
  if (document === undefined) throw new Error(texts.frame.nothingOpen);
  const entry = readExact(await api.documentText(document));
  return (entry as { readonly document: ExactJson }).document;
}
