// The list of stored runs. No channel of the stream tells of it: it is loaded when the panel opens, after each action, and on demand.
import { applyRunList, kNoRuns, type RunList, type RunListEvent } from "../../shared/runs/list";
import { api, session } from "../client";
import { createStore, useSelected } from "../../page/store";

export const runs = createStore<RunList, RunListEvent>(kNoRuns, applyRunList);

export const useRuns = (): RunList => useSelected(runs, (list) => list);

/** The last question for a part: an answer to an earlier one does not count. */
let questions = 0;

/** Loads the newest runs, of a document if it is named. */
export async function loadRuns(document: string | undefined): Promise<void> {
  const question = ++questions;
  const part = await api.runs(document);
  if (question === questions) runs.dispatch({ type: "newest", part });
}

export async function loadOlder(document: string | undefined): Promise<void> {
  const { next } = runs.get();
  if (next === undefined) return;
  const question = ++questions;
  const part = await api.runs(document, next);
  if (question === questions) runs.dispatch({ type: "older", part });
}

/** Removes a run for good, with the core that hosts it. */
export async function removeRun(id: string): Promise<void> {
  if (session.get().cores.some((core) => core.id === id)) await api.deleteCore(id);
  await api.deleteRun(id);
  runs.dispatch({ type: "removed", id });
}
