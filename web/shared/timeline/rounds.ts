// The rounds of the loops of a run: in which one it is, and how long they took by the clock of who watches it.
import type { JsonValue } from "../json";
import type { ModelTree } from "../model/modelTree";
import type { LiveState } from "../run/liveState";
import type { Step } from "./timeLine";

type Known = Pick<LiveState, "results" | "parameters">;

/** In which round a loop is that goes on. */
export interface Round {
  readonly loop: Step;
  /** From 1 on. */
  readonly number: number;
  /** Nothing: it is repeated for ever, or until a step ends it. */
  readonly of: number | undefined;
}

const pathOf = (model: ModelTree, id: string | undefined): string | undefined => (id === undefined ? undefined : [...model.values()].find(({ node }) => node.id === id)?.path);
const countIn = (value: JsonValue | undefined): number | undefined => (typeof value === "number" && value > 0 ? value : undefined);

/** How many rounds of a loop are done since it was entered; nothing: nothing counts them. */
export function doneIn({ counter }: Step, model: ModelTree, { results }: Pick<Known, "results">): number | undefined {
  const path = pathOf(model, counter);
  return path === undefined ? undefined : (countIn(results.get(path)?.["done"]) ?? 0);
}

/** Of the loops among these steps. `active`: ids of the states that are. */
export function roundsIn(steps: readonly Step[], model: ModelTree, run: Known, active: ReadonlySet<string>): readonly Round[] {
  return steps.flatMap((loop) => {
    const [path, done] = [pathOf(model, loop.counter), doneIn(loop, model, run)];
    if (path === undefined || done === undefined) return [];
    const told = run.parameters.get(path)?.["times"];
    const value = loop.repeat?.value;
    const of = typeof told === "number" ? countIn(told) : value?.kind === "constant" ? countIn(value.value) : undefined;
    // While it is counted, the round is not over yet.
    const number = Math.max(1, loop.counter !== undefined && active.has(loop.counter) ? done : done + 1);
    return [{ loop, number: of === undefined ? number : Math.min(number, of), of }];
  });
}

/** How long the rounds of a loop took [ms]. */
export interface RoundTimes {
  readonly isActive: boolean;
  readonly done: number;
  /** When the round began that goes on; nothing: it is not known, or it was held meanwhile, so its time says nothing. */
  readonly began: number | undefined;
  /** Of the last round that was timed. */
  readonly last: number | undefined;
  readonly sum: number;
  readonly count: number;
}

export interface Seen {
  readonly isActive: boolean;
  /** Rounds since the loop was entered. */
  readonly done: number;
  /** The run is held, or what it did was not seen. */
  readonly isHeld: boolean;
  /** [ms] */
  readonly now: number;
}

/** `before`: nothing: the loop is seen for the first time. */
export function timed(before: RoundTimes | undefined, { isActive, done, isHeld, now }: Seen): RoundTimes {
  if (before === undefined) return { isActive, done, began: undefined, last: undefined, sum: 0, count: 0 };
  const rounds = before.isActive ? done - before.done : 0;
  const times = rounds > 0 && before.began !== undefined && !isHeld ? { last: (now - before.began) / rounds, sum: before.sum + now - before.began, count: before.count + rounds } : {};
  const begins = isActive && !isHeld && (!before.isActive || rounds > 0);
  const goesOn = isActive && !isHeld && before.isActive && rounds === 0;
  const began = begins ? now : goesOn ? before.began : undefined;
  if (isActive === before.isActive && done === before.done && began === before.began) return before;
  return { ...before, ...times, isActive, done, began };
}
