// The page's one connection to the server: what it knows of runs and services, and the requests that it makes.
import type { CellPose, Core } from "../generated/messages";
import { createPageStream } from "../page/pageStream";
import { createRights } from "../page/rights";
import { createStore, slowly, useSelected } from "../page/store";
import { kNoPlaces } from "../shared/drawing/places";
import { newestRun } from "../shared/live/shownRun";
import type { StreamUpdate } from "../shared/messages/stream";
import { modelKey } from "../shared/run/edits";
import { createModelLoader } from "../shared/session/modelLoader";
import { applyEvent, emptySession, watchedCore, type Session, type SessionEvent } from "../shared/session/session";
import { isUrgent } from "../shared/session/urgent";

export const session = createStore<Session, SessionEvent>(emptySession, applyEvent);
const shownSession = slowly(session, isUrgent);
export const useSession = <T>(select: (state: Session) => T): T => useSelected(shownSession, select);

const page = createPageStream(session);
export const { access, fetchWithControls: fetcher, api, bystander, ownControls, useLogin, logIn, listenToStream, problem, dismissProblem, attempt, loadDocuments, robotSpeed } = page;
export const me = () => page.login.get().me;
export const rights = createRights(page.login);
export const { refusalNow, useRefusal, useRefusalOfCommand } = rights;

/** The newest pose of the cell, while somebody looks at it. */
export const cellPose = createStore<CellPose | undefined, CellPose | undefined>(undefined, (_, pose) => pose);

function opened(): void {
  models.forget();
  void loadDocuments();
  void api.health().then((health) => session.dispatch({ type: "server", ...health }), problem);
}

function taken(update: StreamUpdate): void {
  if (update.type === "cores" || update.type === "core" || update.type === "core_removed") watchNewest();
  const core = watchedCore(session.get());
  if (core !== undefined && modelKey(core) !== session.get().modelKey) models.load(core.id, modelKey(core));
}

/** To be called once; the connection stays until the page is closed. */
export function connect(): void {
  page.connect({
    channels: ["cores", "services", "control"],
    onConnection: (connection) => connection === "open" && opened(),
    take: (update) => {
      if (update.type === "cell") cellPose.dispatch(update.pose);
      return update.type === "cell" || update.type === "display";
    },
    onTaken: taken,
  });
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
  if (before !== undefined) page.stream()?.unsubscribe(`core/${before}/state`);
  session.dispatch({ type: "watched", id });
  models.forget();
  if (id !== undefined) page.stream()?.subscribe(`core/${id}/state`);
}

export const useCore = (): Core | undefined => useSession(watchedCore);
