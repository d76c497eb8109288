// The times of all macro steps of a run, as far as they are recorded.
import type { Run, ServiceChange, Timing } from "../../generated/messages";
import type { Api } from "../api";

/** All times: [us] since the run was made. */
export interface RunTimes {
  /** When macro step `step` began, from 0 (the run was made) to the last one; of one whose time is not recorded, that of the last one before. It never falls. */
  readonly began: (step: number) => number;
  /** When the next one began; after the last one, when the run was over, infinite if it is not. */
  readonly next: (step: number) => number;
  readonly isTimed: (step: number) => boolean;
  /** When the event or response had come that it delivers, if that is known. */
  readonly arrived: (step: number) => number | undefined;
  /** Macro steps whose time is not recorded. */
  readonly untimed: number;
  /** In order of time, each change once, as long as the run was not over: a few milliseconds more may be recorded. */
  readonly services: readonly ServiceChange[];
}

/** The server tells the times of so many macro steps at once. */
const kPart = 1000;
const kMillisecond = 1000;

/** Each answer says the states anew with which it begins. */
function addServices(known: Map<string, ServiceChange>, all: ServiceChange[], { services }: Timing): void {
  for (const change of services) {
    const before = known.get(change.service);
    if (before !== undefined && (change.time <= before.time || change.state === before.state)) continue;
    known.set(change.service, change);
    all.push(change);
  }
}

/** Of what the server says of all macro steps of the run, in order. */
export function runTimes({ steps, created, ended }: Pick<Run, "steps" | "created" | "ended">, timings: readonly Timing[]): RunTimes {
  const [begins, arrivals] = [new Float64Array(steps + 1).fill(NaN), new Float64Array(steps + 1).fill(NaN)];
  const services: ServiceChange[] = [];
  const known = new Map<string, ServiceChange>();
  for (const timing of timings) {
    for (const { step, time, arrived } of timing.steps) {
      begins[step] = time;
      if (arrived !== undefined) arrivals[step] = arrived;
    }
    addServices(known, services, timing);
  }
  const timed = begins.map((time) => (Number.isNaN(time) ? 0 : 1));
  let last = 0;
  for (const [step, time] of begins.entries()) {
    last = Number.isNaN(time) ? last : Math.max(last, time);
    begins[step] = last;
  }
  // When it was over is told by the millisecond.
  const end = ended === undefined ? Infinity : Math.max(last, (ended - created) * kMillisecond);
  const isTimed = (step: number) => timed[step] === 1;
  const nextTimed = new Float64Array(steps + 1).fill(end);
  for (let step = steps - 1; step >= 0; step--) nextTimed[step] = isTimed(step + 1) ? (begins[step + 1] ?? end) : (nextTimed[step + 1] ?? end);
  return {
    began: (step) => begins[Math.min(step, steps)] ?? 0,
    next: (step) => nextTimed[Math.min(step, steps)] ?? end,
    isTimed,
    arrived: (step) => (Number.isNaN(arrivals[step] ?? NaN) ? undefined : arrivals[step]),
    untimed: steps - timed.slice(1).reduce((sum, one) => sum + one, 0),
    services: services.filter(({ time }) => time <= end).sort((a, b) => a.time - b.time),
  };
}

/** The same, asked for in parts. */
export async function loadRunTimes(api: Pick<Api, "timing">, run: Run, signal: AbortSignal): Promise<RunTimes> {
  const timings: Timing[] = [];
  for (let from = 1; from <= run.steps; from += kPart) {
    signal.throwIfAborted();
    timings.push(await api.timing(run.id, from, Math.min(run.steps, from + kPart - 1)));
  }
  return runTimes(run, timings);
}
