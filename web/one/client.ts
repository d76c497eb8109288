// The page's one connection to the server: what it knows of runs and services, and the requests that it makes.
import type { CellPose, Core } from "../generated/messages";
import { createAccount } from "../page/account";
import { createRights } from "../page/rights";
import { createStore, slowly, useSelected } from "../page/store";
import { createApi } from "../shared/api";
import { kNoPlaces } from "../shared/drawing/places";
import { newestRun } from "../shared/live/shownRun";
import type { Access } from "../shared/login/access";
import { messageOf } from "../shared/messageOf";
import type { StreamUpdate } from "../shared/messages/stream";
import { modelKey } from "../shared/run/edits";
import { createModelLoader } from "../shared/session/modelLoader";
import { applyEvent, emptySession, watchedCore, type Session, type SessionEvent } from "../shared/session/session";
import { isUrgent } from "../shared/session/urgent";
import { openStream, type Connection, type Stream } from "../shared/stream";
import { stop } from "../stop/page";

export const session = createStore<Session, SessionEvent>(emptySession, applyEvent);
const shownSession = slowly(session, isUrgent);
export const useSession = <T>(select: (state: Session) => T): T => useSelected(shownSession, select);

export const { login, access, fetchWithControls: fetcher, api, ownControls, ownStream } = createAccount(() => stream?.reopen());
/** For what is only asked: it is answered also when the controls have just been lost. */
export const bystander = createApi("/api/v1", access.fetch);
export const useLogin = <T>(select: (access: Access) => T): T => useSelected(login, select);
export const me = () => login.get().me;
export const rights = createRights(login);
export const { refusalNow, useRefusal, useRefusalOfCommand } = rights;

export async function logIn(name: string, password: string): Promise<void> {
  await access.logIn(name, password);
  stream?.retry();
}

/** The newest pose of the cell, while somebody looks at it. */
export const cellPose = createStore<CellPose | undefined, CellPose | undefined>(undefined, (_, pose) => pose);

let stream: Stream | undefined;

export interface StreamListener {
  readonly update: (update: StreamUpdate) => void;
  readonly connection: (connection: Connection) => void;
}
const listeners = new Set<StreamListener>();

/** All that comes from now on; the result ends that. Requires `connect`. */
export function listenToStream(listener: StreamListener): { readonly stream: Stream; readonly end: () => void } {
  if (stream === undefined) throw new Error("the page is not connected");
  listeners.add(listener);
  return { stream, end: () => listeners.delete(listener) };
}

export function problem(error: unknown): void {
  session.dispatch({ type: "problem", text: messageOf(error) });
}

/** Does something, and says why it has failed. */
export async function attempt(action: () => Promise<unknown>): Promise<void> {
  try {
    await action();
  } catch (error) {
    problem(error);
  }
}

export async function loadDocuments(): Promise<void> {
  try {
    session.dispatch({ type: "documents", documents: await api.documents() });
  } catch (error) {
    if (session.get().connection !== "lost") problem(error);
  }
}

/** To be called once; the connection stays until the page is closed. */
export function connect(): void {
  stream = openStream(ownStream, {
    onConnection: (connection, ended) => {
      if (connection !== "connecting" && !access.get().asked) void access.ask().catch(() => undefined); // the account may have changed
      session.dispatch({ type: "connection", connection, ended });
      stop.connection(connection);
      listeners.forEach((listener) => listener.connection(connection));
      if (connection !== "open") return;
      models.forget();
      void loadDocuments();
      void api.health().then((health) => session.dispatch({ type: "server", ...health }), problem);
    },
    onMalformed: problem,
    onUpdate: (update) => {
      if (update.type === "cell") cellPose.dispatch(update.pose);
      else if (update.type === "control") stop.take(update.control);
      else if (update.type !== "display") session.dispatchInFrame((frame) => ({ type: "update", update, frame }));
      if (update.type === "cores" || update.type === "core" || update.type === "core_removed") watchNewest();
      const core = watchedCore(session.get());
      if (core !== undefined && modelKey(core) !== session.get().modelKey) models.load(core.id, modelKey(core));
      listeners.forEach((listener) => listener.update(update));
    },
  });
  for (const channel of ["cores", "services", "control"]) stream.subscribe(channel);
}

const models = createModelLoader((id) => api.coreModel(id), {
  onModel: (id, key, model) => session.dispatch({ type: "model", id, key, model, places: kNoPlaces }),
  onError: problem,
});

let application: string | undefined;

/** From now on, the newest run of this application is watched. */
export function watchApplication(name: string | undefined): void {
  application = name;
  watchNewest();
}

function watchNewest(): void {
  watch(application === undefined ? undefined : newestRun(session.get().cores, application)?.id);
}

function watch(id: string | undefined): void {
  const before = session.get().watched;
  if (id === before) return;
  if (before !== undefined) stream?.unsubscribe(`core/${before}/state`);
  session.dispatch({ type: "watched", id });
  models.forget();
  if (id !== undefined) stream?.subscribe(`core/${id}/state`);
}

export const useCore = (): Core | undefined => useSession(watchedCore);
