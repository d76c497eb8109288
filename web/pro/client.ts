// The page's one connection to the server: stores, requests and the stream, wired together.
import { isRefusal } from "../shared/api";
import type { CellPose, Core, Packet, TraceStep } from "../generated/messages";
import type { RunSource } from "../shared/api";
import { kNoPlaces, type Places } from "../shared/drawing/places";
import { runPlaces } from "../shared/drawing/runPlaces";
import type { RcmDocument } from "../shared/model/model";
import { buildTree } from "../shared/model/modelTree";
import { modelKey } from "../shared/run/edits";
import { firstShown, lastShown, type LastShown } from "../shared/session/firstShown";
import { createModelLoader } from "../shared/session/modelLoader";
import { loadStoredRun } from "../shared/runs/storedRun";
import { applyEvent, cellUnavailable, emptySession, isStored, watchedCore, type Session, type SessionEvent } from "../shared/session/session";
import { applyGesture, firstView, type Gesture, type View } from "../shared/session/view";
import { addressWith, placeOfAddress } from "../shared/session/address";
import { isUrgent } from "../shared/session/urgent";
import { coreToWatch } from "../shared/session/watched";
import type { StreamUpdate } from "../shared/messages/stream";
import { createPageStream } from "../page/pageStream";
import { createStore, slowly, useSelected } from "../page/store";

const kPastSteps = 40;

export const session = createStore<Session, SessionEvent>(emptySession, applyEvent);
export const view = createStore<View, Gesture>(firstView({ width: innerWidth, height: innerHeight }), applyGesture);

const page = createPageStream(session);
export const { login, access, fetchWithControls, api, ownControls, ownStream, useLogin, logIn, listenToStream, problem, dismissProblem, attempt, loadDocuments, robotSpeed } = page;

/** The newest pose of the cell. It changes many times a second, so it bypasses the session. */
export const cellPose = createStore<CellPose | undefined, CellPose | undefined>(undefined, (_, pose) => pose);
/** After an interruption the old pose is not valid, nor is one that was still on its way. */
const takePose = (pose: CellPose): void => cellPose.dispatch(cellUnavailable(session.get()) === undefined ? pose : undefined);
session.listen(() => cellUnavailable(session.get()) !== undefined && cellPose.dispatch(undefined));

/** For what is read: of a run that goes on by itself, late by a tenth of a second at most. */
export const shownSession = slowly(session, isUrgent);
export const useSession = <T>(select: (state: Session) => T): T => useSelected(shownSession, select);
export const useView = <T>(select: (state: View) => T): T => useSelected(view, select);
export const useCore = (): Core | undefined => useSession(watchedCore);

const flowWatchers = new Map<string, ReadonlySet<(packet: Packet) => void>>();

/** Derivations are collected for this time, so that a run of a hundred steps in a second does not redraw the list as often: longer while
 *  so many steps come that nobody can read them [ms]. */
const kGather = { slow: 100, fast: 600 };
/** More steps in the time of slow ones are fast. */
const kReadable = 3;
let gatherTime = kGather.slow;
let gathered: { readonly id: string; readonly steps: TraceStep[] } | undefined;

function gather(id: string, steps: readonly TraceStep[]): void {
  if (gathered?.id === id) {
    gathered.steps.push(...steps);
    return;
  }
  const begun = (gathered = { id, steps: [...steps] });
  setTimeout(() => {
    if (gathered === begun) gathered = undefined;
    gatherTime = begun.steps.length * kGather.slow > kReadable * gatherTime ? kGather.fast : kGather.slow;
    session.dispatchInFrame((frame) => ({ type: "update", update: { type: "derivations", ...begun }, frame }));
  }, gatherTime);
}

/** Updates that say of which edit the model of a core is. */
const kBringsCore: ReadonlySet<StreamUpdate["type"]> = new Set(["cores", "core", "state", "state_changed"]);

function take(update: StreamUpdate): boolean {
  if (update.type === "cell") takePose(update.pose);
  else if (update.type === "packet") flowWatchers.get(update.channel)?.forEach((came) => came(update.packet));
  else if (update.type === "derivations") gather(update.id, update.steps);
  else return false;
  return true;
}

function taken(update: StreamUpdate): void {
  if (update.type === "derivation_position") void loadPast(update.id, update.next);
  if (update.type === "cores" || update.type === "core" || update.type === "core_removed") watchSomething();
  if (kBringsCore.has(update.type)) refreshModel();
}

/** Opens the stream and loads what never changes; the connection stays until the page is closed. */
export function connect(): void {
  page.connect({ channels: ["cores", "services", "control", "log", "cell/pose"], onConnection: (connection) => connection === "open" && opened(), take, onTaken: taken });
}

function opened(): void {
  void loadLists();
  listed = loadDocuments();
  models.forget();
  refreshModel();
}

/** Loads the model of the watched core if the page has none of its last edit. */
function refreshModel(): void {
  const core = watchedCore(session.get());
  if (core !== undefined && !isStored(session.get()) && modelKey(core) !== session.get().modelKey) loadModel(core.id);
}

async function loadLists(): Promise<void> {
  try {
    session.dispatch({ type: "server", ...(await api.health()) });
    session.dispatch({ type: "rules", rules: await api.rules() });
  } catch (error) {
    problem(error);
  }
}

async function loadPast(id: string, next: number): Promise<void> {
  if (next <= 1) return;
  try {
    session.dispatch({ type: "past", id, steps: await api.derivations(id, Math.max(1, next - kPastSteps), next - 1) });
  } catch (error) {
    problem(error);
  }
}

/** What answers questions about the watched run. */
export const sourceOf = (now: Session): RunSource => (isStored(now) ? "runs" : "cores");

/** Keeps the watched run while it is there, also over a restart of the server; else that of the address, which may only be stored; else chooses one. */
function watchSomething(): void {
  const { cores, watched, stored } = session.get();
  if (watched !== undefined && (stored !== undefined || cores.some((core) => core.id === watched))) return;
  const { run: wanted, edit } = placeOfAddress(location.search);
  if (wanted === undefined || cores.some((core) => core.id === wanted)) watch(coreToWatch(cores, wanted, edit)?.id);
  else if (opening !== wanted) void openFromAddress(wanted);
}

/** The run of the address that is being loaded from the store. */
let opening: string | undefined;

/** Where there is no such run, another one is watched; what cannot be had now is asked for again with the next message about cores. */
async function openFromAddress(id: string): Promise<void> {
  opening = id;
  const { watched } = session.get();
  try {
    await watchStored(id);
  } catch (error) {
    if (session.get().watched !== watched) return;
    if (!(isRefusal(error) && error.status < 500)) {
      if (session.get().connection !== "lost") problem(error);
      return;
    }
    history.replaceState(null, "", addressWith(location.search, { run: undefined, at: undefined }));
    watchSomething();
  } finally {
    opening = undefined;
  }
}

/** From this, the next run of the same document is shown. */
let last: LastShown | undefined;

/** Ends that the run is watched which was until now; `turn` turns to another one, `id`. The address keeps the moment of that, if it has one. */
function turnTo(id: string | undefined, turn: () => void): void {
  const { watched: before } = session.get();
  if (view.get().page !== "edit") last = lastShown(session.get(), view.get(), last);
  if (before !== undefined) page.stream()?.unsubscribe(`core/${before}/state`);
  if (id !== undefined) history.replaceState(null, "", addressWith(location.search, { run: id, ...(placeOfAddress(location.search).run !== id && { at: undefined }) }));
  turn();
  view.dispatch({ type: "forget_run" });
  models.forget();
}

export function watch(id: string | undefined): void {
  if (session.get().watched === id) return;
  turnTo(id, () => session.dispatch({ type: "watched", id }));
  if (id === undefined) return;
  page.stream()?.subscribe(`core/${id}/state`);
  loadModel(id);
}

/** Turns to a run that no core hosts. Throws what the server refuses. */
export async function watchStored(id: string): Promise<void> {
  const { watched } = session.get();
  const run = await loadStoredRun(api, id, (core, model) => placesOf(core, model).catch(() => kNoPlaces));
  if (session.get().watched !== watched) return;
  turnTo(id, () => session.dispatch({ type: "stored", run }));
  showModel(run.model);
}

/** Shows a run: the core of this number, else what is stored of it. Throws what the server refuses. */
export async function turnToRun(id: string): Promise<void> {
  const { cores, watched } = session.get();
  if (id === watched) return;
  if (cores.some((core) => core.id === id)) watch(id);
  else await watchStored(id);
}

/** The list of documents, when it came first. */
let listed: Promise<void> | undefined;

const isListed = (core: Core): boolean => session.get().documents.some(({ name, revision }) => name === core.document && revision >= core.revision);

/** Where people have placed what a run executes; nowhere, if its document is not there any more. */
async function placesOf(core: Core | undefined, model: RcmDocument | Promise<RcmDocument>): Promise<Places> {
  if (core === undefined) return kNoPlaces;
  await listed;
  // It may have been edited since.
  if (!isListed(core)) await loadDocuments();
  if (!isListed(core)) return kNoPlaces;
  const { document, places } = await api.modelAt(core.document, core.revision);
  return runPlaces(document, (await model).root, places);
}

async function loadRun(id: string): Promise<{ readonly model: RcmDocument; readonly places: Places }> {
  const model = api.coreModel(id);
  // It is drawn, if need be without the places.
  const places = placesOf(session.get().cores.find((core) => core.id === id), model).catch(() => kNoPlaces);
  return { model: await model, places: await places };
}

/** The model of a run is shown for the first time: as that of the run before, if both are of one document. */
function showModel({ root }: RcmDocument): void {
  view.dispatch({ type: "show_run", shown: firstShown(buildTree(root), session.get().document, last, view.get().detail) });
}

const models = createModelLoader(loadRun, {
  onModel: (id, key, { model, places }) => {
    const now = session.get();
    if (now.watched !== id || now.modelKey === key) return;
    if (now.model === undefined) showModel(model);
    session.dispatch({ type: "model", id, key, model, places });
  },
  onError: problem,
});

function loadModel(id: string): void {
  const core = watchedCore(session.get());
  models.load(id, core === undefined ? "" : modelKey(core));
}

/** Lets the watched core follow the edits of its document, or not. */
export async function follow(live: boolean): Promise<void> {
  const core = watchedCore(session.get());
  if (core === undefined) return;
  try {
    await api.setLive(core.id, live);
  } catch (error) {
    problem(error);
  }
}

/** Watches a data flow; the result ends that. Its service produces packets while anybody does. Each call needs a function of its own. */
export function watchFlow(service: string, flow: string, came: (packet: Packet) => void): () => void {
  const channel = `flow/${service}/${flow}`;
  const others = flowWatchers.get(channel);
  flowWatchers.set(channel, new Set([...(others ?? []), came]));
  if (others === undefined) page.stream()?.subscribe(channel);
  return () => {
    const left = new Set(flowWatchers.get(channel));
    left.delete(came);
    if (left.size > 0) return void flowWatchers.set(channel, left);
    flowWatchers.delete(channel);
    page.stream()?.unsubscribe(channel);
  };
}
