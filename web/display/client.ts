// The page's one connection: what the server says changes the page's stores, and what a person does is sent to the server.
import { applyDisplayEvent, canAnswer, firstPage, kDefaultName, nameOf, placeOf, type DisplayEvent, type DisplayPage } from "../shared/display/page";
import type { Key } from "../shared/display/numberText";
import type { StreamUpdate } from "../shared/messages/stream";
import { applyEvent, emptySession, watchedCore, type Session, type SessionEvent } from "../shared/session/session";
import { coreToWatch } from "../shared/session/watched";
import { createPageStream } from "../page/pageStream";
import { createRights } from "../page/rights";
import { createStore, useSelected } from "../page/store";
import type { PairAnswer } from "../generated/messages";
import { playSound } from "./signals";

/** The display's name in the address; undefined if it is none. */
export const ownName = nameOf(location.search);
const ownPlace = placeOf(location.search);

export const display = createStore<DisplayPage, DisplayEvent>(firstPage(ownName ?? kDefaultName), applyDisplayEvent);
export const session = createStore<Session, SessionEvent>(emptySession, applyEvent);
export const useDisplay = <T>(select: (page: DisplayPage) => T): T => useSelected(display, select);
export const useSession = <T>(select: (state: Session) => T): T => useSelected(session, select);

const page = createPageStream(session);
export const { login, access, fetchWithControls, api, ownControls, useLogin, logIn, problem, dismissProblem, attempt, loadDocuments, robotSpeed } = page;
export const rights = createRights(login);
export const { useRefusal, useRefusalOfCommand, useRefusalToStart } = rights;

/** Answers the question that is shown. */
export function answer(question: number, given: string | number): void {
  if (canAnswer(display.get()) && page.stream()?.send({ type: "answer", question, answer: given }) === true) display.dispatch({ type: "sent" });
}
export const press = (button: string): void => void page.stream()?.send({ type: "press", button });
export const key = (which: Key): void => display.dispatch({ type: "key", key: which });

/** Exchanges the code of a pairing for a token of this device. */
export async function pair(code: string): Promise<PairAnswer> {
  const paired = await access.pair(code);
  page.stream()?.reopen();
  return paired;
}

/** The page may play sounds from now on. */
export function soundAllowed(): void {
  if (display.get().sound) return;
  display.dispatch({ type: "sound" });
  page.stream()?.announceDisplay(display.get().name, true, ownPlace);
}

/** Turns to another run. */
export function watch(id: string | undefined): void {
  const { watched } = session.get();
  if (watched === id) return;
  if (watched !== undefined) page.stream()?.unsubscribe(`core/${watched}/state`);
  session.dispatch({ type: "watched", id });
  if (id !== undefined) page.stream()?.subscribe(`core/${id}/state`);
}

function watchSomething(): void {
  if (watchedCore(session.get()) === undefined) watch(coreToWatch(session.get().cores, undefined)?.id);
}

/** What is of the display itself. */
function take(update: StreamUpdate): boolean {
  if (update.type === "display") {
    display.dispatch({ type: "content", content: update.content });
    playSound(update.content.sound, display.get().sound, (id) => page.stream()?.send({ type: "played", sound: id }));
    return true;
  }
  if (update.type !== "refused" || display.get().content !== undefined) return false;
  display.dispatch({ type: "problem", text: update.errors.map((error) => error.message).join("; ") });
  return true;
}

/** Runs until the page is closed. */
export function connect(): void {
  const opened = page.connect({
    channels: ["control", "services", "cores"],
    onConnection: (connection) => {
      display.dispatch({ type: "connection", connection });
      if (connection === "open") void loadDocuments();
    },
    onMalformed: (error) => display.dispatch({ type: "problem", text: error.message }),
    take,
    onTaken: ({ type }) => (type === "cores" || type === "core" || type === "core_removed") && watchSomething(),
  });
  opened.announceDisplay(display.get().name, false, ownPlace);
}
