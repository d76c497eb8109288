import { describe, expect, it } from "vitest";
import type { LogEntry, TraceStep } from "../../generated/messages";
import { loggedStep } from "../../shared/runs/callLog";
import { forcedLines, matchingLines, runLog } from "../../shared/runs/runLog";
import { timesOf } from "../../shared/runs/times";

const log: readonly LogEntry[] = [
  { time: 1, source: "core/3", text: "other: ready" },
  { time: 4, source: "core/7", text: "pick: ready" },
  { time: 5, source: "core/7", text: "pick: running" },
  { time: 9, source: "robot", text: "stands" },
];
const steps: readonly TraceStep[] = [
  { step: 1, input: { kind: "start" }, micro: [], calls: [] },
  { step: 2, input: { kind: "force", force: { path: "Root", scope: "var", name: "n", value: 3 } }, micro: [], calls: [] },
  { step: 3, input: { kind: "force", force: { path: "Root/A", scope: "port", name: "done" } }, micro: [], calls: [] },
];
const entries = steps.flatMap((step) => loggedStep(step).entries);
const times = timesOf({ steps: [{ step: 1, time: 1e6 }, { step: 2, time: 3e6 }, { step: 3, time: 6e6 }], services: [], until: 7e6 });
const texts = (lines: ReturnType<typeof runLog>) => lines.map(({ time, text }) => `${time ?? "-"} ${text}`);

describe("the log of a run", () => {
  it("has what was forced, where it happened", () => {
    expect(texts(runLog(log, forcedLines(log, "7", entries, times)))).toEqual(["1 other: ready", "4 pick: ready", "5 pick: running", "7 forced: Root var.n = 3", "9 stands", "10 forced: Root/A.done"]);
  });
  it("has it before the end of the run, whatever the clocks say", () => {
    const ended = [...log, { time: 9.5, source: "core/7", text: "pick: ended at done" }];
    expect(texts(runLog(ended, forcedLines(ended, "7", entries, times))).slice(-2)).toEqual(["9.5 forced: Root/A.done", "9.5 pick: ended at done"]);
  });
  it("has it at the end, without a time, of a run whose beginning is not in the log, or whose times are not known", () => {
    for (const forced of [forcedLines(log.filter(({ time }) => time !== 4), "7", entries, times), forcedLines(log, "7", entries, undefined)])
      expect(texts(runLog(log, forced)).slice(-2)).toEqual(["- forced: Root var.n = 3", "- forced: Root/A.done"]);
  });
  it("is searched by source and text", () => {
    const lines = runLog(log, forcedLines(log, "7", entries, times));
    expect(texts(matchingLines(lines, " FORCED "))).toHaveLength(2);
    expect(texts(matchingLines(lines, "robot"))).toEqual(["9 stands"]);
    expect(matchingLines(lines, " ")).toBe(lines);
  });
});
