// The pose of the cell that is shown: as it was in the macro step of the past that the page looks at, if that was sampled, else as it is.
import type { CellPose, Samples } from "../../generated/messages";
import { poseAt } from "../../shared/past/samples";
import { api, cellPose, session } from "../client";
import { createStore, slowly, useSelected } from "../../page/store";

export interface ShownPose {
  readonly pose: CellPose;
  /** The macro step of the past; nothing: it is the present. */
  readonly step: number | undefined;
}

export const shownPose = createStore<ShownPose | undefined, ShownPose | undefined>(undefined, (_, shown) => shown);

/** What is read of it, as text. */
export const readPose = slowly(shownPose, (before, now) => before?.step !== now?.step);

/** Whether the cell is shown as it was. */
export const usePastCell = (): boolean => useSelected(shownPose, (shown) => shown?.step !== undefined);

/** The samples of the last run that was looked at. They are stored a few seconds late, so those of a run that goes on are asked for again [ms]. */
let known: { readonly id: string; readonly samples: Samples; readonly at: number } | undefined;
const kFresh = 5000;
let loading: string | undefined;

async function load(id: string): Promise<void> {
  if (loading === id) return;
  loading = id;
  // A run without samples is shown in the cell as it is.
  const samples = await api.samples(id).catch(() => []);
  known = { id, samples, at: performance.now() };
  loading = undefined;
  refresh();
}

function pastPose(): ShownPose | undefined {
  const { watched, past } = session.get();
  if (watched === undefined || past === undefined) return undefined;
  const { step } = past.past;
  const samples = known?.id === watched ? known.samples : undefined;
  if (samples === undefined || ((samples.at(-1)?.step ?? 0) < step && performance.now() - (known?.at ?? 0) > kFresh)) void load(watched);
  const pose = samples && poseAt(samples, step);
  return pose && { pose, step };
}

function refresh(): void {
  const before = shownPose.get();
  const now = cellPose.get();
  const shown = pastPose() ?? (now && { pose: now, step: undefined });
  if (before?.pose !== shown?.pose || before?.step !== shown?.step) shownPose.dispatch(shown);
}
cellPose.listen(refresh);
session.listen(refresh);
