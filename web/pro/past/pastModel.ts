// What the run executed in a macro step of the past: an edit may have changed its model since.
import { readNative } from "../../shared/api";
import { Refusal } from "../../shared/edit/refusal";
import type { RcmDocument } from "../../shared/model/model";
import type { ModelsOfRun } from "../../shared/past/models";
import { loadModels } from "../../shared/runs/storedRun";
import { isStored, watchedCore } from "../../shared/session/session";
import type { Native } from "../../generated/messages";
import { api, session } from "../client";
import { messageOf } from "../../shared/messageOf";

/** `model`: nothing if it is the one that the page has already; `doubt`: why that may be another. */
interface Then {
  readonly model: RcmDocument | undefined;
  readonly doubt: string | undefined;
}

const kSame: Then = { model: undefined, doubt: undefined };
const read = new WeakMap<Native, RcmDocument>();

/** The last run that was asked about; an edit of it makes its models anew. */
let known: { readonly key: string; readonly models: Promise<ModelsOfRun | undefined> } | undefined;

function modelsOf(id: string, edits: number): Promise<ModelsOfRun | undefined> {
  const key = `${id}/${edits}`;
  if (known?.key !== key) known = { key, models: api.storedRun(id).then((run) => loadModels(api, run)) };
  return known.models;
}

function modelOf(native: Native): RcmDocument {
  const before = read.get(native);
  const model = before ?? readNative(native);
  if (before === undefined) read.set(native, model);
  return model;
}

const doubtful = (reason: string): Then => ({ model: undefined, doubt: `The model that is drawn may be another than it was then: ${reason}.` });

/** The model of run `id` in macro step `step`. */
export async function modelThen(id: string, step: number): Promise<Then> {
  const now = session.get();
  const core = watchedCore(now);
  // A run that is hosted says since when its model is what it is.
  if (core === undefined || (!isStored(now) && step >= core.model)) return kSame;
  try {
    const models = await modelsOf(id, core.model);
    const native = models?.(step);
    if (native !== undefined && native === models?.(core.step)) return kSame;
    if (native === undefined) return doubtful("the journal of the run is too long to look for edits");
    return native instanceof Refusal ? doubtful(native.message) : { model: modelOf(native), doubt: undefined };
  } catch (error) {
    known = undefined;
    return doubtful(messageOf(error));
  }
}
