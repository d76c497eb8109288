// The page's one connection to the server: stores, requests and the stream, wired together.
import { createApi, RefusedError } from "../shared/api";
import type { CellPose, Core, Packet, StepRequest, TraceStep } from "../generated/messages";
import { foldedAtFirst } from "../shared/model/folding";
import { buildTree } from "../shared/model/modelTree";
import { isOver, type Command } from "../shared/run/controls";
import { applyEvent, cellAway, emptySession, watchedCore, type Session, type SessionEvent } from "../shared/session/session";
import { applyGesture, firstView, type Gesture, type View } from "../shared/session/view";
import { openStream, type Stream } from "../shared/stream";
import { createStore, useSelected } from "./store";

const kPastSteps = 40;

export const session = createStore<Session, SessionEvent>(emptySession, applyEvent);
export const view = createStore<View, Gesture>(firstView({ width: innerWidth, height: innerHeight }), applyGesture);
export const api = createApi("/api/v1", (input, init) => fetch(input, init));

/** The newest pose of the cell: many per second, so it goes past the session, straight to who draws it. */
export const cellPose = createStore<CellPose | undefined, CellPose | undefined>(undefined, (_, pose) => pose);
// A world that comes back is not where the last one was.
session.listen(() => cellAway(session.get()) !== undefined && cellPose.dispatch(undefined));

export const useSession = <T>(select: (state: Session) => T): T => useSelected(session, select);
export const useView = <T>(select: (state: View) => T): T => useSelected(view, select);
export const useCore = (): Core | undefined => useSession(watchedCore);

let stream: Stream | undefined;
const flowWatchers = new Map<string, (packet: Packet) => void>();

/** Shows what went wrong until a person puts it away. */
export function problem(error: unknown): void {
  const text = error instanceof RefusedError || error instanceof Error ? error.message : String(error);
  session.dispatch({ type: "problem", text });
}

/** Derivations wait this long for others, so that a run of a hundred steps in a second does not draw the list as often [ms]. */
const kGather = 100;
let gathered: { readonly id: string; readonly steps: TraceStep[] } | undefined;

function gather(id: string, steps: readonly TraceStep[]): void {
  if (gathered?.id === id) {
    gathered.steps.push(...steps);
    return;
  }
  const begun = (gathered = { id, steps: [...steps] });
  setTimeout(() => {
    if (gathered === begun) gathered = undefined;
    session.dispatch({ type: "news", news: { type: "derivations", ...begun } });
  }, kGather);
}

/** Opens the stream and asks for what never changes; the page lives as long as the document. */
export function connect(): void {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  stream = openStream(`${scheme}://${location.host}/api/v1/stream`, {
    onConnection: (connection) => {
      session.dispatch({ type: "connection", connection });
      if (connection === "open") void loadLists();
    },
    onMalformed: problem,
    onNews: (news) => {
      if (news.type === "cell") cellPose.dispatch(news.pose);
      else if (news.type === "packet") flowWatchers.get(news.channel)?.(news.packet);
      else if (news.type === "derivations") gather(news.id, news.steps);
      else session.dispatch({ type: "news", news });
      if (news.type === "derivation_position") void loadPast(news.id, news.next);
      if (news.type === "cores" || news.type === "core") watchSomething();
    },
  });
  for (const channel of ["cores", "services", "log", "cell/pose"]) stream.subscribe(channel);
}

async function loadLists(): Promise<void> {
  try {
    session.dispatch({ type: "cell", present: (await api.health()).cell });
    session.dispatch({ type: "rules", rules: await api.rules() });
    session.dispatch({ type: "documents", documents: await api.documents() });
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

/** Without a choice of the person, the page watches the core that runs, or else the newest. */
function watchSomething(): void {
  const { cores, watched } = session.get();
  if (watched !== undefined && cores.some((core) => core.id === watched)) return;
  const chosen = cores.filter((core) => !isOver(core)).at(-1) ?? cores.at(-1);
  watch(chosen?.id);
}

export function watch(id: string | undefined): void {
  const before = session.get().watched;
  if (before === id) return;
  if (before !== undefined) {
    stream?.unsubscribe(`core/${before}/state`);
    stream?.unsubscribe(`core/${before}/derivation`);
  }
  session.dispatch({ type: "watched", id });
  view.dispatch({ type: "forget" });
  if (id === undefined) return;
  stream?.subscribe(`core/${id}/state`);
  stream?.subscribe(`core/${id}/derivation`);
  void api.coreModel(id).then((model) => {
    if (session.get().watched !== id) return;
    view.dispatch({ type: "collapse_all", paths: foldedAtFirst(buildTree(model.root)) });
    session.dispatch({ type: "model", id, model });
  }, problem);
}

/** Watches a data flow until the answer is called: its service works for it meanwhile. One watch of a flow at a time. */
export function watchFlow(service: string, flow: string, came: (packet: Packet) => void): () => void {
  const channel = `flow/${service}/${flow}`;
  flowWatchers.set(channel, came);
  stream?.subscribe(channel);
  return () => {
    flowWatchers.delete(channel);
    stream?.unsubscribe(channel);
  };
}

/** Makes a core of a document, watches it, and starts it if asked. */
export async function newRun(document: string, start: boolean, args: Core["arguments"] = {}): Promise<void> {
  try {
    const core = await api.createCore(document, args);
    session.dispatch({ type: "news", news: { type: "core", core } });
    watch(core.id);
    if (start) await api.start(core.id);
  } catch (error) {
    problem(error);
  }
}

/** Carries a command out on the watched core. */
export async function run(command: Command, until?: Extract<StepRequest, { readonly kind: "until" }>): Promise<void> {
  const core = watchedCore(session.get());
  if (core === undefined) return;
  try {
    switch (command) {
      case "start":
      case "pause":
      case "resume":
      case "stop":
        await api[command](core.id);
        return;
      case "again":
        await newRun(core.document, true, core.arguments);
        return;
      case "micro":
      case "macro":
        await stepFrom(core, { kind: command });
        return;
      case "until":
        if (until !== undefined) await stepFrom(core, until);
    }
  } catch (error) {
    problem(error);
  }
}

/** A core that was not started is held first, so that it does this step and no more. */
async function stepFrom(core: Core, step: StepRequest): Promise<void> {
  if (core.status === "ready") {
    if (!core.paused) await api.pause(core.id);
    await api.start(core.id);
  }
  await api.step(core.id, step);
}

export function dismissProblem(): void {
  session.dispatch({ type: "problem", text: undefined });
}
