// Where a time line draws a macro step: each as wide as the others, or by the time at which it began.
import type { Span, Timeline } from "./timeline";
import type { Times } from "./times";

export type Measure = "seconds" | "steps";

export interface Scale {
  readonly measure: Measure;
  /** What is drawn, from 0 on: macro steps, or seconds. */
  readonly width: number;
  /** What the left end is, in the same unit. */
  readonly origin: number;
  /** Where macro step `step` begins; also of the one after the last. */
  readonly at: (step: number) => number;
  /** The macro step that is drawn at a place. */
  readonly stepAt: (place: number) => number;
  /** Where a time is [us since the run was made]: by macro steps, between the two that it lies between. Nothing: no times are known. */
  readonly atTime: ((time: number) => number) | undefined;
  /** How many macro steps have no time that is known, and stand at the next one that has. */
  readonly unknown: number;
}

/** What is shorter than this part of a row is drawn as wide. */
const kLeastPart = 0.002;

/** From where to where a span is drawn, within the row; by macro steps, what begins and ends in one is half of it. */
export function barOf({ from, to }: Span, { measure, width, at }: Scale): readonly [number, number] {
  const begin = Math.min(at(from), width * (1 - kLeastPart));
  const least = measure === "steps" ? 0.5 : width * kLeastPart;
  return [begin, Math.max(to === undefined ? width : at(to), begin + Math.max(least, width * kLeastPart))];
}

const kSecond = 1e6;
/** What lasts for no time is drawn so wide [s]. */
const kLeast = 0.001;

/** Where times are among macro steps, each as wide as the others: what passes between two of them is as wide as a step. */
function amongSteps(line: Timeline, times: Times): (time: number) => number {
  const ends = [...timesInOrder(line, times), times.until];
  return (time) => {
    const next = ends.findIndex((end) => time < end);
    if (next < 0) return ends.length - 1;
    const [from, to] = [ends[next - 1], ends[next] ?? 0];
    return from === undefined ? 0 : next - 1 + (time - from) / (to - from);
  };
}

function byStep(line: Timeline, times: Times | undefined): Scale {
  const { first, last } = line;
  const width = last - first + 1;
  return {
    measure: "steps", width, origin: first, unknown: 0,
    at: (step) => Math.min(width, Math.max(0, step - first)),
    stepAt: (place) => first + Math.min(width - 1, Math.max(0, Math.floor(place))),
    atTime: times && amongSteps(line, times),
  };
}

/** The time of each macro step, none before that of an earlier one: clocks of people may be set back while no server runs. */
function timesInOrder({ first, last }: Timeline, { began, until }: Times): readonly number[] {
  const times: number[] = [];
  for (let step = last, next = until; step >= first; step--) {
    next = Math.min(next, began.get(step) ?? next);
    times.unshift(next);
  }
  return times;
}

function byTime(line: Timeline, times: Times, isOver: boolean): Scale {
  const { first, last } = line;
  const began = timesInOrder(line, times);
  const start = began[0] ?? 0;
  const end = isOver ? (began.at(-1) ?? start) : times.until;
  const width = Math.max(kLeast, (end - start) / kSecond);
  const place = (time: number) => Math.min(width, Math.max(0, (time - start) / kSecond));
  const at = (step: number) => (step > last ? width : place(began[Math.max(0, step - first)] ?? start));
  const runStart = times.began.get(1) ?? start;
  return {
    measure: "seconds", width, origin: (start - runStart) / kSecond, at, atTime: place,
    unknown: began.filter((_, i) => !times.began.has(first + i)).length,
    stepAt: (where) => first + Math.max(0, began.filter((_, i) => at(first + i) <= where).length - 1),
  };
}

/** By seconds if they are wanted and any is known, else by macro steps. `isOver`: nothing comes after the last one. */
export function scaleOf(wanted: Measure, line: Timeline, times: Times | undefined, isOver: boolean): Scale {
  const isKnown = times !== undefined && [...times.began.keys()].some((step) => step >= line.first && step <= line.last);
  return wanted === "seconds" && isKnown ? byTime(line, times, isOver) : byStep(line, isKnown ? times : undefined);
}
