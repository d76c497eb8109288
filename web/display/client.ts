// The page's one connection: what the server says changes the page's stores, and what a person does is sent to the server.
import { applyDisplayEvent, canAnswer, firstPage, kDefaultName, nameOf, placeOf, type DisplayEvent, type DisplayPage } from "../shared/display/page";
import type { Key } from "../shared/display/numberText";
import type { Access } from "../shared/login/access";
import { messageOf } from "../shared/messageOf";
import type { StreamUpdate } from "../shared/messages/stream";
import { watchReach } from "../shared/reach";
import { applyEvent, emptySession, watchedCore, type Session, type SessionEvent } from "../shared/session/session";
import { coreToWatch } from "../shared/session/watched";
import { openStream, type Stream } from "../shared/stream";
import { controls, every } from "../control/page";
import { createAccount } from "../page/account";
import { createRights } from "../page/rights";
import { createStore, useSelected } from "../page/store";
import { stop } from "../stop/page";
import type { PairAnswer } from "../generated/messages";
import { playSound } from "./signals";

/** The display's name in the address; undefined if it is none. */
export const ownName = nameOf(location.search);
const ownPlace = placeOf(location.search);

export const display = createStore<DisplayPage, DisplayEvent>(firstPage(ownName ?? kDefaultName), applyDisplayEvent);
export const session = createStore<Session, SessionEvent>(emptySession, applyEvent);
export const useDisplay = <T>(select: (page: DisplayPage) => T): T => useSelected(display, select);
export const useSession = <T>(select: (state: Session) => T): T => useSelected(session, select);

export const { login, access, fetchWithControls, api, ownControls, ownStream } = createAccount(() => stream?.reopen());
export const useLogin = <T>(select: (access: Access) => T): T => useSelected(login, select);
export const rights = createRights(login);
export const { useRefusal, useRefusalOfCommand, useRefusalToStart } = rights;

let stream: Stream | undefined;

/** Says what is in the way, until somebody has read it. */
export const problem = (error: unknown): void => session.dispatch({ type: "problem", text: messageOf(error) });
export const dismissProblem = (): void => session.dispatch({ type: "problem", text: undefined });

/** Does what a person wants, and says what was in the way. */
export function attempt(action: () => Promise<unknown>): void {
  action().catch(problem);
}

/** Answers the question that is shown. */
export function answer(question: number, given: string | number): void {
  if (canAnswer(display.get()) && stream?.send({ type: "answer", question, answer: given }) === true) display.dispatch({ type: "sent" });
}
export const press = (button: string): void => void stream?.send({ type: "press", button });
export const key = (which: Key): void => display.dispatch({ type: "key", key: which });

export async function logIn(account: string, password: string): Promise<void> {
  await access.logIn(account, password);
  stream?.retry();
}

/** Exchanges the code of a pairing for a token of this device. */
export async function pair(code: string): Promise<PairAnswer> {
  const paired = await access.pair(code);
  stream?.reopen();
  return paired;
}

/** The page may play sounds from now on. */
export function soundAllowed(): void {
  if (display.get().sound) return;
  display.dispatch({ type: "sound" });
  stream?.announceDisplay(display.get().name, true, ownPlace);
}

/** Turns to another run. */
export function watch(id: string | undefined): void {
  const { watched } = session.get();
  if (watched === id) return;
  if (watched !== undefined) stream?.unsubscribe(`core/${watched}/state`);
  session.dispatch({ type: "watched", id });
  if (id !== undefined) stream?.subscribe(`core/${id}/state`);
}

function watchSomething(): void {
  if (watchedCore(session.get()) === undefined) watch(coreToWatch(session.get().cores, undefined)?.id);
}

/** Loads the list of documents, which no channel tells of. */
export function loadDocuments(): void {
  attempt(async () => session.dispatch({ type: "documents", documents: await api.documents() }));
}

function take(update: StreamUpdate): void {
  if (update.type === "display") {
    display.dispatch({ type: "content", content: update.content });
    playSound(update.content.sound, display.get().sound, (id) => stream?.send({ type: "played", sound: id }));
  } else if (update.type === "control") stop.take(update.control);
  else if (update.type === "refused" && display.get().content === undefined) display.dispatch({ type: "problem", text: update.errors.map((error) => error.message).join("; ") });
  else session.dispatchInFrame((frame) => ({ type: "update", update, frame }));
  if (update.type === "cores" || update.type === "core" || update.type === "core_removed") watchSomething();
}

/** Runs until the page is closed. */
export function connect(): void {
  const opened = openStream(ownStream, {
    onConnection: (connection, ended) => {
      if (connection === "lost" && !access.get().asked) void access.ask().catch(() => undefined); // the account may have changed
      stop.connection(connection);
      display.dispatch({ type: "connection", connection });
      session.dispatch({ type: "connection", connection, ended });
      if (connection === "open") loadDocuments();
    },
    onMalformed: (error) => display.dispatch({ type: "problem", text: error.message }),
    onUpdate: take,
  });
  stream = opened;
  opened.announceDisplay(display.get().name, false, ownPlace);
  for (const channel of ["control", "services", "cores"]) opened.subscribe(channel);
  watchReach({
    fetcher: (input, init) => fetch(input, init),
    every,
    timeout: (time) => AbortSignal.timeout(time),
    isSeen: () => !document.hidden && display.get().connection === "open",
    onLost: () => {
      controls.release("the server does not answer");
      opened.abandon();
    },
  });
}
