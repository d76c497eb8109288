// The state of the expert page as a value, and the function that applies an event to it.
import { assertNever } from "../assertNever";
import { mergeSteps } from "../derivation/steps";
import type { Call, Core, DocumentSummary, HostedService, Input, LogEntry, Rule, TraceStep } from "../../generated/messages";
import type { StreamUpdate } from "../messages/stream";
import { kNoPlaces, type Places } from "../drawing/places";
import type { RcmDocument } from "../model/model";
import type { ShownPast } from "../past/shown";
import { applyDelta } from "../run/applyDelta";
import { liveState, type LiveState } from "../run/liveState";
import { isOver } from "../run/controls";
import { modelKey } from "../run/edits";
import { withForced, type Forced } from "../run/forced";
import { applyFired, noneFired, type Fired } from "../run/fired";
import { kNothingTold, tellDisplays, type OnDisplays } from "../run/onDisplays";
import { withQuestions } from "../run/waitingForPerson";
import type { StoredRun } from "../runs/storedRun";
import type { Connection } from "../stream";

export interface Session {
  readonly connection: Connection;
  /** It is lost because the server has ended, as it said. */
  readonly ended: boolean;
  /** Whether the server has a cell to show. */
  readonly cell: boolean;
  /** When the process of the server began [ms since 1970]; nothing: not known. */
  readonly started: number | undefined;
  /** Another process of the server has answered since the page was loaded; until the user dismisses it. */
  readonly restarted: boolean;
  readonly documents: readonly DocumentSummary[];
  readonly rules: ReadonlyMap<string, Rule>;
  readonly cores: readonly Core[];
  /** Whether `cores` has come from the server. */
  readonly listed: boolean;
  /** The run that is watched. */
  readonly watched: string | undefined;
  /** What is stored of the watched run, if no core hosts it (runs/storedRun.ts). */
  readonly stored: Core | undefined;
  /** Name of the document of the watched core, also after that core was removed. */
  readonly document: string | undefined;
  readonly model: RcmDocument | undefined;
  /** Where people have placed what `model` has. */
  readonly places: Places;
  /** Of which edit of the run `model` is (modelKey). */
  readonly modelKey: string | undefined;
  readonly run: LiveState | undefined;
  /** The moment of the past that is shown instead (past/shown.ts). */
  readonly past: ShownPast | undefined;
  readonly fired: Fired;
  readonly lastInput: Input | undefined;
  /** What the watched run has told the displays since the page watches it. */
  readonly onDisplays: OnDisplays;
  /** What it has asked people since then, the last questions. */
  readonly questions: readonly Call[];
  /** What was forced in it since then. */
  readonly forced: readonly Forced[];
  /** How often its whole state came: what was before is in no delta. */
  readonly snapshots: number;
  readonly steps: readonly TraceStep[];
  readonly services: readonly HostedService[];
  readonly log: readonly LogEntry[];
  /** The latest error, until the user dismisses it. */
  readonly problem: string | undefined;
}

export type SessionEvent =
  | { readonly type: "connection"; readonly connection: Connection; readonly ended?: boolean | undefined }
  /** What the server is that answers now. */
  | { readonly type: "server"; readonly cell: boolean; readonly started?: number | undefined }
  | { readonly type: "restart_seen" }
  | { readonly type: "documents"; readonly documents: readonly DocumentSummary[] }
  | { readonly type: "rules"; readonly rules: readonly Rule[] }
  | { readonly type: "watched"; readonly id: string | undefined }
  | { readonly type: "model"; readonly id: string; readonly key: string; readonly model: RcmDocument; readonly places: Places }
  | { readonly type: "past"; readonly id: string; readonly steps: readonly TraceStep[] }
  /** Turns to a run that no core hosts. */
  | { readonly type: "stored"; readonly run: StoredRun }
  /** Turns to a moment of run `id`, or, with nothing, back to its present. */
  | { readonly type: "moment"; readonly id: string; readonly shown: ShownPast | undefined }
  /** `frame`: of the page, in which it is shown together with others. */
  | { readonly type: "update"; readonly update: StreamUpdate; readonly frame?: number }
  | { readonly type: "problem"; readonly text: string | undefined };

const kLogLines = 500;

export const emptySession: Session = {
  connection: "connecting",
  ended: false,
  cell: false,
  started: undefined,
  restarted: false,
  documents: [],
  rules: new Map(),
  cores: [],
  listed: false,
  watched: undefined,
  stored: undefined,
  document: undefined,
  model: undefined,
  places: kNoPlaces,
  modelKey: undefined,
  run: undefined,
  past: undefined,
  fired: noneFired,
  lastInput: undefined,
  onDisplays: kNothingTold,
  questions: [],
  forced: [],
  snapshots: 0,
  steps: [],
  services: [],
  log: [],
  problem: undefined,
};

/** What is watched: a core, or what is stored of a run, as the core was that hosted it. */
export function watchedCore({ cores, watched, stored }: Session): Core | undefined {
  return cores.find((core) => core.id === watched) ?? stored;
}

/** Whether the watched run is stored, and hosted by no core. */
export const isStored = ({ cores, watched, stored }: Session): boolean => stored !== undefined && cores.every((core) => core.id !== watched);

/** The watched core, if a command can reach it; of a run that is only stored, a new one can be made once it is over. */
export function commandable(session: Session): Core | undefined {
  const core = watchedCore(session);
  if (session.connection === "lost" || core === undefined) return undefined;
  return isStored(session) && !isOver(core) ? undefined : core;
}

/** Why the scene of the cell cannot be loaded now: the server or the process of `robot` is not connected. */
export function cellUnavailable({ connection, services }: Session): string | undefined {
  if (connection !== "open") return "the server is not there";
  return services.some(({ key, available }) => key === "robot" && !available) ? "its process is not there" : undefined;
}

export function applyEvent(session: Session, event: SessionEvent): Session {
  switch (event.type) {
    case "connection":
      // A server that was lost is lost until it answers.
      if (session.connection === "lost" && event.connection !== "open") return session;
      return { ...session, connection: event.connection, ended: event.ended ?? false };
    case "server":
      return { ...session, cell: event.cell, started: event.started, restarted: session.restarted || (session.started !== undefined && event.started !== undefined && event.started !== session.started) };
    case "restart_seen":
      return { ...session, restarted: false };
    case "documents":
      return { ...session, documents: event.documents };
    case "rules":
      return { ...session, rules: new Map(event.rules.map((rule) => [rule.rule, rule])) };
    case "watched":
      return {
        ...session,
        watched: event.id,
        document: session.cores.find((core) => core.id === event.id)?.document,
        model: undefined,
        places: kNoPlaces,
        modelKey: undefined,
        run: undefined,
        stored: undefined,
        past: undefined,
        fired: noneFired,
        steps: [],
        lastInput: undefined,
        onDisplays: kNothingTold,
        questions: [],
        forced: [],
      };
    case "stored": {
      const { core, model, places, state, steps } = event.run;
      const turned = applyEvent(session, { type: "watched", id: core.id });
      return { ...turned, stored: core, document: core.document, model, places, modelKey: modelKey(core), run: state && liveState(state), steps };
    }
    case "moment":
      return event.id === session.watched ? { ...session, past: event.shown } : session;
    case "model":
      return event.id === session.watched ? { ...session, model: event.model, places: event.places, modelKey: event.key } : session;
    case "past":
      return event.id === session.watched ? { ...session, steps: mergeSteps(event.steps, session.steps) } : session;
    case "update":
      return applyUpdate(session, event.update, event.frame);
    case "problem":
      return { ...session, problem: event.text };
    default:
      return assertNever(event);
  }
}

function withCore(cores: readonly Core[], core: Core): readonly Core[] {
  return cores.some((known) => known.id === core.id)
    ? cores.map((known) => (known.id === core.id ? core : known))
    : [...cores, core];
}

/** The core in a snapshot of the state is as it was at the last input; of what has changed without one, the list of cores knows. */
function withCounters(cores: readonly Core[], core: Core): readonly Core[] {
  const { step, micro, waiting } = core;
  const known = cores.find(({ id }) => id === core.id);
  return withCore(cores, known === undefined ? core : { ...known, step, micro, waiting });
}

function applyUpdate(session: Session, update: StreamUpdate, frame?: number): Session {
  switch (update.type) {
    case "cores":
      return { ...session, cores: update.cores, listed: true };
    case "core":
      return { ...session, cores: withCore(session.cores, update.core) };
    case "core_removed":
      return { ...session, cores: session.cores.filter((core) => core.id !== update.id) };
    case "state":
      if (update.id !== session.watched) return session;
      return { ...session, cores: withCounters(session.cores, update.state.core), snapshots: session.snapshots + 1, run: liveState(update.state.state) };
    case "state_changed": {
      if (update.id !== session.watched || session.run === undefined) return session;
      const fired = applyFired(session.fired, update.delta, frame);
      const cores = withCore(session.cores, update.delta.core);
      const onDisplays = tellDisplays(session.onDisplays, update.delta, session.services);
      const questions = withQuestions(session.questions, update.delta.calls);
      return { ...session, cores, run: applyDelta(session.run, update.delta), fired, lastInput: update.delta.input ?? session.lastInput, onDisplays, questions, forced: withForced(session.forced, update.delta) };
    }
    case "derivations":
      return update.id === session.watched ? { ...session, steps: mergeSteps(session.steps, update.steps) } : session;
    case "services":
      return { ...session, services: update.services };
    case "services_changed":
      return {
        ...session,
        services: session.services.map((service) => ({ ...service, ...update.services.find((change) => change.key === service.key) })),
      };
    case "log":
      return { ...session, log: [...(update.whole ? [] : session.log), ...update.entries].slice(-kLogLines) };
    case "refused":
      // That more are at a document than are shown is told there, as is that there is no such document.
      if (update.channel.startsWith("presence/") || update.channel.startsWith("document/")) return session;
      return { ...session, problem: update.errors.map((error) => error.message).join("; ") };
    case "derivation_position":
    case "cell":
    case "control":
    case "display":
    case "packet":
    case "document":
    case "document_edited":
    case "edit_accepted":
    case "edit_refused":
    case "people":
    case "people_changed":
    case "joined":
    case "proposals":
      return session;
    default:
      return assertNever(update);
  }
}
