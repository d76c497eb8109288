// The work of the page's main thread in each frame, from a trace of the browser: seconds of processor, so that other load on the machine does not count.
import type { Page } from "playwright-core";

/** Of a stretch of time in which the page is busy. */
export interface FrameWork {
  readonly framesPerSecond: number;
  /** Share of frames that came later than a thirtieth of a second after the one before. */
  readonly late: number;
  /** Main-thread work of a frame [ms]. */
  readonly mean: number;
  readonly most95: number;
}

interface TraceEvent {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  readonly dur?: number;
  readonly tdur?: number;
  readonly args?: { readonly name?: string };
}

const kCategories = ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline", "__metadata"];

/** The value below which a share of the values lies. */
export function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0;
}

const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / Math.max(1, values.length);

/** The main thread of the page: of all renderers the one that runs most. */
function mainThreadTasks(events: readonly TraceEvent[]): readonly TraceEvent[] {
  const isTask = ({ name, ph }: TraceEvent) => name === "RunTask" && ph === "X";
  const threads = events.filter(({ name, args }) => name === "thread_name" && args?.name === "CrRendererMain");
  const tasks = threads.map(({ pid, tid }) => events.filter((event) => isTask(event) && event.pid === pid && event.tid === tid));
  return tasks.sort((a, b) => b.length - a.length)[0] ?? [];
}

/** Carries out `busy`, and tells how the page has worked meanwhile. */
export async function frameWorkDuring(page: Page, busy: () => Promise<void>): Promise<FrameWork> {
  const browser = page.context().browser();
  if (browser === null) throw new Error("the page has no browser");
  await browser.startTracing(page, { categories: kCategories });
  await page.evaluate(() => void window.benchProbe.frames.splice(0));
  await busy();
  const frames = await page.evaluate(() => [...window.benchProbe.frames]);
  const trace = JSON.parse((await browser.stopTracing()).toString()) as { readonly traceEvents: readonly TraceEvent[] };
  const tasks = mainThreadTasks(trace.traceEvents);
  const starts = trace.traceEvents.filter(({ name, tid, pid }) => name === "FireAnimationFrame" && tid === tasks[0]?.tid && pid === tasks[0].pid).map(({ ts }) => ts);
  const perFrame = workBetween(tasks, [...new Set(starts)].sort((a, b) => a - b));
  const gaps = frames.slice(1).map((at, i) => at - (frames[i] ?? at));
  return {
    framesPerSecond: 1000 / mean(gaps),
    late: gaps.filter((gap) => gap > 1000 / 30 + 1).length / Math.max(1, gaps.length),
    mean: mean(perFrame),
    most95: quantile(perFrame, 0.95),
  };
}

/** The callbacks of a frame lie so close together [us]. */
const kSameFrame = 4000;

/** The work of the tasks that begin in each frame [ms]; frames begin at `starts` [us]. */
function workBetween(tasks: readonly TraceEvent[], starts: readonly number[]): readonly number[] {
  const begins = starts.filter((at, i) => i === 0 || at - (starts[i - 1] ?? 0) > kSameFrame);
  const work = new Array<number>(Math.max(0, begins.length - 1)).fill(0);
  // The task of a frame begins before its first callback.
  const ordered = [...tasks].sort((a, b) => a.ts - b.ts);
  let frame = -1;
  for (const { ts, dur = 0, tdur = dur } of ordered) {
    while (frame + 1 < begins.length && ts + dur > (begins[frame + 1] ?? Infinity)) frame++;
    if (frame >= 0 && frame < work.length) work[frame] = (work[frame] ?? 0) + tdur / 1000;
  }
  return work;
}
