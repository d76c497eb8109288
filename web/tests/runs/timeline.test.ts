import { describe, expect, it } from "vitest";
import type { Input, TraceStep } from "../../generated/messages";
import { timesOf } from "../../shared/runs/times";
import { csvOf, lineStep, seriesOf, timelineOf } from "../../shared/runs/timeline";

const state = (active: readonly string[], n: number | string, other = 1) => ({ active, ports: [], activated: {}, parameters: { Root: { other } }, results: {}, variables: { "Root/A": { n } } });
const start: Input = { kind: "start" };
const answer = (call: number, more: object): Input => ({ kind: "response", service: "timer", operation: "start", call, ...more }) as Input;
const call = (number: number) => ({ service: "timer", operation: "start", args: [number], kwargs: {}, call: number });
const step = (number: number, input: Input, active: readonly string[], n: number | string, calls: TraceStep["calls"] = []): TraceStep => ({ step: number, input, micro: [], calls, state: state(active, n) });

const steps = [
  step(4, start, ["Root", "Root/A"], 1, [call(1), call(2)]),
  step(5, answer(1, { result: null }), ["Root", "Root/B"], 2),
  step(6, answer(2, { error: "late" }), ["Root", "Root/A"], "none", [call(3)]),
].map(lineStep);
const line = timelineOf(steps);
const times = timesOf({ steps: [{ step: 1, time: 500 }], services: [], until: 500 });

describe("a time line", () => {
  it("has the spans of each state that was active, as often as it was", () => {
    expect([line.first, line.last]).toEqual([4, 6]);
    expect(line.states).toEqual([
      { path: "Root", spans: [{ from: 4, to: undefined }] },
      { path: "Root/A", spans: [{ from: 4, to: 5 }, { from: 6, to: undefined }] },
      { path: "Root/B", spans: [{ from: 5, to: 6 }] },
    ]);
  });
  it("has each call until its answer, and says if that was an error", () => {
    expect(line.calls.map(({ text, from, to, failed }) => [text, from, to, failed])).toEqual([["timer.start(1)", 4, 5, false], ["timer.start(2)", 4, 6, true], ["timer.start(3)", 6, undefined, false]]);
  });
  it("offers the numbers that change, with gaps where there is none", () => {
    expect(line.numbers).toEqual(["Root/A.var.n"]);
    expect(seriesOf(steps, "Root/A.var.n")).toEqual([1, 2, null]);
  });
  it("is written as comma-separated values, a row for each macro step", () => {
    expect(csvOf(steps, undefined)).toBe("step,input,seconds,Root.par.other,Root/A.var.n\r\n4,start,,1,1\r\n5,response,,1,2\r\n6,response,,1,\r\n");
    expect(csvOf([{ step: 1, input: start, calls: [], called: [], active: [], numbers: new Map([['R.par.a"b,c', 0.5]]) }], times)).toBe('step,input,seconds,"R.par.a""b,c"\r\n1,start,0,0.5\r\n');
  });
});
