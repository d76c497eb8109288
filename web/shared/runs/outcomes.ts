// What many runs came to, in numbers.
import type { Run } from "../../generated/messages";
import { isBadOutcome } from "../run/controls";

export interface Outcomes {
  /** Runs that are over, of those that are listed. */
  readonly over: number;
  readonly finished: number;
  readonly failed: number;
  /** By a person. */
  readonly stopped: number;
  /** [ms] of the newest one that has finished; nothing: none has. */
  readonly last: number | undefined;
  /** [ms] of those that have finished. */
  readonly mean: number | undefined;
}

/** `runs`: the newest first. */
export function outcomesOf(runs: readonly Pick<Run, "status" | "outcome" | "created" | "ended">[]): Outcomes {
  const finished = runs.filter(({ status, outcome }) => status === "ended" && !isBadOutcome(outcome));
  const stopped = runs.filter(({ status }) => status === "aborted").length;
  const failed = runs.filter(({ status, outcome }) => status === "faulted" || (status === "ended" && isBadOutcome(outcome))).length;
  const times = finished.flatMap(({ created, ended }) => (ended === undefined ? [] : [Math.max(0, ended - created)]));
  const mean = times.length === 0 ? undefined : times.reduce((sum, time) => sum + time, 0) / times.length;
  return { over: finished.length + failed + stopped, finished: finished.length, failed, stopped, last: times[0], mean };
}
