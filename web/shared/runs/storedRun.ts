// A stored run as the page shows it: like the core that hosted it, at its end, with its model, its state and its last derivations.
import type { Core, Run, RunState, TraceStep } from "../../generated/messages";
import { readNative, type Api } from "../api";
import type { Places } from "../drawing/places";
import { Refusal } from "../edit/refusal";
import type { RcmDocument } from "../model/model";
import { modelsOfRun, type ModelsOfRun } from "../past/models";

export interface StoredRun {
  readonly core: Core;
  readonly model: RcmDocument;
  readonly places: Places;
  /** Nothing: it was never started. */
  readonly state: RunState | undefined;
  readonly steps: readonly TraceStep[];
}

/** The run, as its core would be. One that is not over stands still. */
export function coreOfRun({ id, document, revision, arguments: given, status, steps, outcome, results, fault }: Run): Core {
  const isOpen = status === "running" || status === "interrupted";
  return {
    id, document, revision, arguments: given, status: isOpen ? "running" : status, paused: isOpen, stepping: false, step: steps, micro: 0, waiting: 0, breakpoints: [],
    live: false, model: 0, ...(outcome !== undefined && { outcome }), ...(results !== undefined && { results }), ...(fault !== undefined && { fault }),
  };
}

/** A longer journal is not loaded for the edits that may be in it [bytes]. */
export const kMostJournal = 4 << 20;
/** So many of its last macro steps are loaded with their derivations. */
const kSteps = 40;

/** The models of a run, by its journal; nothing if that is too long. */
export async function loadModels(api: Pick<Api, "journal">, { id, bytes }: Pick<Run, "id" | "bytes">): Promise<ModelsOfRun | undefined> {
  return bytes > kMostJournal ? undefined : modelsOfRun(await api.journal(id));
}

/** All that is shown of the run. Throws what the server refuses. */
export async function loadStoredRun(api: Api, id: string, placesOf: (core: Core, model: RcmDocument) => Promise<Places>): Promise<StoredRun> {
  const run = await api.storedRun(id);
  const core = coreOfRun(run);
  const last = run.steps;
  const [models, past, steps] = await Promise.all([
    loadModels(api, run),
    last === 0 ? undefined : api.past("runs", id, { step: last }),
    last === 0 ? [] : api.derivations(id, Math.max(1, last - kSteps + 1), last, "runs"),
  ]);
  const native = models?.(last);
  const model = native === undefined || native instanceof Refusal ? await api.runModel(id) : readNative(native);
  return { core, model, places: await placesOf(core, model), state: past?.state, steps };
}
