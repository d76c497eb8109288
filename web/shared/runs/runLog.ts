// The server's log with what was forced in the watched run, in the order in which it happened.
import type { LogEntry } from "../../generated/messages";
import type { RunEntry } from "./callLog";
import { secondsAt, type Times } from "./times";

/** A line of the log; `forced`: what was forced, and in which macro step. */
export interface LogLine {
  /** As in the log [s]; nothing: not known. */
  readonly time: number | undefined;
  readonly source: string;
  readonly text: string;
  readonly forced?: { readonly step: number };
}

/** What the log says of the run: when it began, in this process of the server, and when it was over. */
function spanOf(log: readonly LogEntry[], source: string): { readonly began: number; readonly over: number } | undefined {
  const lines = log.filter((line) => line.source === source);
  const began = lines.find(({ text }) => text.endsWith(": running"))?.time;
  const over = lines.find(({ text }) => /: (ended|faulted|aborted)/.test(text))?.time ?? Infinity;
  return began === undefined || !lines.some(({ text }) => text.endsWith(": ready")) ? undefined : { began, over };
}

/** The entries of the run that were forced, as lines. Its times count from when it was made, those of the log are of the cell: both know when it began. */
export function forcedLines(log: readonly LogEntry[], run: string, entries: readonly RunEntry[], times: Times | undefined): readonly LogLine[] {
  const source = `core/${run}`;
  const span = spanOf(log, source);
  return entries
    .filter(({ kind }) => kind === "force")
    .map(({ step, text }) => {
      const since = times === undefined ? undefined : secondsAt(times, step);
      return { time: span === undefined || since === undefined ? undefined : Math.min(span.began + since, span.over), source, text: text.replace(/^force /, "forced: "), forced: { step } };
    });
}

/** Both in order of time; what has none, or is newer than all lines, is last. A run is over after what was forced in it. */
export function runLog(log: readonly LogEntry[], forced: readonly LogLine[]): readonly LogLine[] {
  const found: LogLine[] = [...log];
  for (const line of forced) {
    const next = line.time === undefined ? -1 : found.findIndex(({ time }) => time !== undefined && line.time !== undefined && time >= line.time);
    found.splice(next < 0 ? found.length : next, 0, line);
  }
  return found;
}

/** The lines with this text in their source or their own. */
export function matchingLines(lines: readonly LogLine[], text: string): readonly LogLine[] {
  const wanted = text.trim().toLowerCase();
  return wanted === "" ? lines : lines.filter((line) => `${line.source} ${line.text}`.toLowerCase().includes(wanted));
}
