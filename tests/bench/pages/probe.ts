// What measures in the page: installed before its scripts, and asked afterwards. It runs in the browser alone.
import type { CDPSession, Page } from "playwright-core";

/** A part of the page [px]. */
export interface Region {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

interface Probe {
  /** When a frame of the page began [ms since the page was asked for]. */
  readonly frames: number[];
  readonly longTasks: { readonly from: number; readonly to: number }[];
  /** When the drawing was first shown as a whole [ms]. */
  drawn: number | undefined;
  /** What is painted in a region, as text. */
  readonly pixels: (region: Region) => string;
  /** Resolves with the time from the next key to the frame after the one in which the region has changed [ms]. */
  readonly untilChanged: (region: Region) => Promise<number>;
}

declare global {
  interface Window {
    benchProbe: Probe;
  }
}

function install(): void {
  const frames: number[] = [];
  const longTasks: { from: number; to: number }[] = [];
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries()) longTasks.push({ from: startTime, to: startTime + duration });
  }).observe({ type: "longtask", buffered: true });

  /** The bitmap of the still drawing that is shown, without the overview beneath and the run above it. */
  const painted = () => [...document.querySelectorAll<HTMLCanvasElement>(".painted > canvas")].slice(1, 3).find(({ style }) => style.visibility === "visible");
  const isDrawn = () => document.querySelector('.canvas[aria-busy="false"]') !== null && (painted() !== undefined || document.querySelector(".canvas .react-flow [data-path]") !== null);
  const pixels = ({ x, y, width, height }: Region): string => {
    const canvas = painted();
    if (canvas === undefined) return "";
    const box = canvas.getBoundingClientRect();
    const scale = canvas.width / box.width;
    const [wide, high] = [Math.round(width * scale), Math.round(height * scale)];
    const context = new OffscreenCanvas(wide, high).getContext("2d", { willReadFrequently: true });
    context?.drawImage(canvas, -Math.round((x - box.left) * scale), -Math.round((y - box.top) * scale));
    return context?.getImageData(0, 0, wide, high).data.join() ?? "";
  };
  const probe: Probe = {
    frames,
    longTasks,
    drawn: undefined,
    pixels,
    untilChanged: (region) =>
      new Promise((resolve) => {
        addEventListener(
          "keydown",
          ({ timeStamp }) => {
            const before = pixels(region);
            const look = () => {
              if (pixels(region) === before) requestAnimationFrame(look);
              else requestAnimationFrame((now) => resolve(now - timeStamp));
            };
            requestAnimationFrame(look);
          },
          { capture: true, once: true },
        );
      }),
  };
  window.benchProbe = probe;
  const frame = (now: number) => {
    frames.push(now);
    if (probe.drawn === undefined && isDrawn()) probe.drawn = performance.now();
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

export async function installProbe(page: Page): Promise<void> {
  await countProcessorTime(page);
  await page.addInitScript(install);
}

/** Nothing occupies the page for so long: it can be used [ms]. */
const kQuiet = 500;

/** Times of a page that was just opened [ms]. */
export interface Opening {
  /** The drawing is shown. */
  readonly drawn: number;
  /** It is shown, and no long task runs or follows at once. */
  readonly usable: number;
  /** Processor time of the main thread, until nothing more happens. */
  readonly work: number;
}

export async function openingOf(page: Page): Promise<Opening> {
  await page.waitForFunction(() => window.benchProbe.drawn !== undefined);
  await page.waitForFunction((quiet) => {
    const { drawn = 0, longTasks } = window.benchProbe;
    return performance.now() - Math.max(drawn, longTasks.at(-1)?.to ?? 0) > quiet;
  }, kQuiet);
  const times = await page.evaluate((quiet) => {
    const { drawn = 0, longTasks } = window.benchProbe;
    let usable = drawn;
    for (const { from, to } of longTasks) if (to > usable && from < usable + quiet) usable = to;
    return { drawn, usable };
  }, kQuiet);
  return { ...times, work: await processorTime(page) };
}

const sessions = new WeakMap<Page, CDPSession>();

/** From now on the processor time of the page is counted. To be called before it is opened. */
async function countProcessorTime(page: Page): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  sessions.set(page, session);
}

/** Of the tasks of the main thread so far [ms]. */
async function processorTime(page: Page): Promise<number> {
  const { metrics } = (await sessions.get(page)?.send("Performance.getMetrics")) ?? { metrics: [] };
  return 1000 * (metrics.find(({ name }) => name === "TaskDuration")?.value ?? NaN);
}
