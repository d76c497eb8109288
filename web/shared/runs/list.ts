// The list of stored runs, the newest first, as it is loaded in parts; and what of it is wanted.
import type { Run, Runs, ServerError } from "../../generated/messages";
import { assertNever } from "../assertNever";
import { isBadOutcome } from "../run/controls";
import { outcomeText } from "./texts";
import { counted } from "../counted";

export interface RunList {
  readonly runs: readonly Run[];
  /** There are older ones: `before` of the next request. */
  readonly next: number | undefined;
  /** Runs that the server cannot read. */
  readonly damaged: readonly ServerError[];
}

export type RunListEvent =
  /** The newest runs: the list begins anew. */
  | { readonly type: "newest"; readonly part: Runs }
  | { readonly type: "older"; readonly part: Runs }
  | { readonly type: "changed"; readonly run: Run }
  | { readonly type: "removed"; readonly id: string };

export const kNoRuns: RunList = { runs: [], next: undefined, damaged: [] };

const newestFirst = (a: Run, b: Run): number => Number(b.id) - Number(a.id);

/** Each run once, as it was told last. */
function withRuns(known: readonly Run[], added: readonly Run[]): readonly Run[] {
  const ids = new Set(added.map(({ id }) => id));
  return [...known.filter(({ id }) => !ids.has(id)), ...added].sort(newestFirst);
}

export function applyRunList(list: RunList, event: RunListEvent): RunList {
  switch (event.type) {
    case "newest":
      return { runs: event.part.runs, next: event.part.next, damaged: event.part.damaged ?? [] };
    case "older":
      return { runs: withRuns(list.runs, event.part.runs), next: event.part.next, damaged: [...list.damaged, ...(event.part.damaged ?? [])] };
    case "changed":
      return { ...list, runs: withRuns(list.runs, [event.run]) };
    case "removed":
      return { ...list, runs: list.runs.filter(({ id }) => id !== event.id) };
    default:
      return assertNever(event);
  }
}

/** What a run came to, as far as the filter tells it: `good` and `bad` ends, one that goes on, one that stands still, one that was not started. */
export type Outcome = "good" | "bad" | "open" | "waits" | "ready";

export function outcomeOf({ status, outcome }: Pick<Run, "status" | "outcome">): Outcome {
  switch (status) {
    case "ended":
      return isBadOutcome(outcome) ? "bad" : "good";
    case "faulted":
    case "aborted":
      return "bad";
    case "running":
      return "open";
    case "interrupted":
      return "waits";
    case "ready":
      return "ready";
  }
}

export interface RunQuery {
  /** Words, all of which a run has in its number, document, outcome, arguments or results. */
  readonly text: string;
  /** Nothing: of any. */
  readonly outcome: Outcome | undefined;
}

export function matchingRuns(runs: readonly Run[], { text, outcome }: RunQuery): readonly Run[] {
  const words = text.toLowerCase().split(/\s+/).filter((word) => word !== "");
  return runs.filter((run) => {
    if (outcome !== undefined && outcomeOf(run) !== outcome) return false;
    const about = [run.id, run.document, outcomeText(run), run.fault?.message ?? "", JSON.stringify(run.arguments), JSON.stringify(run.results ?? {})].join(" ").toLowerCase();
    return words.every((word) => about.includes(word));
  });
}

/** What a search has found, as a line over the list. */
export function countText(found: number, { runs, next }: RunList): string {
  const all = counted(runs.length, "run");
  const loaded = next === undefined ? all : `the newest ${all}`;
  return found === runs.length ? (next === undefined ? all : `The newest ${all}`) : `${found} of ${loaded}`;
}
