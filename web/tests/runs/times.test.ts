import { describe, expect, it } from "vitest";
import type { Input, Timing } from "../../generated/messages";
import { barOf, scaleOf } from "../../shared/runs/scale";
import { durationOf, secondsAt, secondsText, servicesShown, timesOf } from "../../shared/runs/times";
import type { LineStep, Timeline } from "../../shared/runs/timeline";

const timing: Timing = {
  steps: [{ step: 4, time: 2_000_000 }, { step: 5, time: 3_000_000, arrived: 2_900_000 }, { step: 7, time: 6_000_000, arrived: 5_900_000 }],
  services: [{ service: "timer", state: "Idle", time: 0 }, { service: "db", state: "Ready", time: 0 }, { service: "timer", state: "Busy", time: 2_500_000 }, { service: "robot", time: 0 }],
  until: 8_000_000,
};
const times = timesOf(timing);
const line: Timeline = { first: 4, last: 7, states: [], calls: [], numbers: [] };
const step = (number: number, input: Input, called: readonly string[] = []): LineStep => ({ step: number, input, calls: [], called, active: [], numbers: new Map() });

describe("the times of a run", () => {
  it("say how long a call took until its answer was there, if both are known", () => {
    const call = { call: 1, text: "", failed: false };
    expect(durationOf({ ...call, from: 4, to: 5 }, times)).toBe(0.9);
    expect(durationOf({ ...call, from: 4, to: undefined }, times)).toBe(undefined);
    expect(durationOf({ ...call, from: 6, to: 7 }, times)).toBe(undefined);
    expect(durationOf({ ...call, from: 4, to: 5 }, undefined)).toBe(undefined);
  });
  it("say which states services had from when to when", () => {
    expect(times.services.find(({ service }) => service === "timer")?.spans).toEqual([{ state: "Idle", from: 0, to: 2_500_000 }, { state: "Busy", from: 2_500_000, to: 8_000_000 }]);
  });
  it("show the services that are used, and those that changed", () => {
    const shown = (steps: readonly LineStep[]) => servicesShown(times, steps).map(({ service }) => service);
    expect(shown([step(4, { kind: "start" })])).toEqual(["timer"]);
    expect(shown([step(4, { kind: "start" }, ["db", "robot"])])).toEqual(["timer", "db"]);
  });
  it("count from the first macro step that is known", () => {
    expect(secondsAt(times, 5)).toBe(1);
    expect(secondsAt(times, 6)).toBe(undefined);
    expect(secondsText(0.3012)).toBe("0.301 s");
    expect(secondsText(12.34)).toBe("12.3 s");
  });
});

describe("the scale of a time line", () => {
  it("draws what was active for no time at the very end within its row", () => {
    const scale = scaleOf("seconds", line, times, true);
    const [begin, end] = barOf({ from: line.last, to: line.last }, scale);
    expect(end).toBeLessThanOrEqual(scale.width);
    expect(end - begin).toBeCloseTo(scale.width * 0.002);
  });
  it("has each macro step where it began, and those without a time at the next one", () => {
    const scale = scaleOf("seconds", line, times, false);
    expect([scale.measure, scale.width, scale.unknown]).toEqual(["seconds", 6, 1]);
    expect([4, 5, 6, 7, 8].map(scale.at)).toEqual([0, 1, 4, 4, 6]);
    expect([0, 0.99, 1, 3.9, 4, 5.9].map(scale.stepAt)).toEqual([4, 4, 5, 5, 7, 7]);
    expect(scale.atTime?.(2_500_000)).toBe(0.5);
    expect(scaleOf("seconds", line, times, true).width).toBe(4);
  });
  it("never goes back", () => {
    const back = timesOf({ steps: [{ step: 4, time: 9_000_000 }, { step: 5, time: 3_000_000 }, { step: 6, time: 4_000_000 }, { step: 7, time: 5_000_000 }], services: [], until: 6_000_000 });
    expect([4, 5, 6, 7, 8].map(scaleOf("seconds", line, back, false).at)).toEqual([0, 0, 1, 2, 3]);
  });
  it("counts macro steps if that is wanted, or no time is known", () => {
    for (const scale of [scaleOf("steps", line, times, false), scaleOf("seconds", line, undefined, false), scaleOf("seconds", { ...line, first: 20, last: 23 }, times, false)]) {
      expect([scale.measure, scale.width]).toEqual(["steps", 4]);
      expect(scale.at(scale.origin + 1)).toBe(1);
      expect(scale.stepAt(1.5)).toBe(scale.origin + 1);
    }
  });
  it("has a time between the macro steps that it lies between, if their times are known", () => {
    const { atTime } = scaleOf("steps", line, times, false);
    // Step 6 has no time, and stands at the next one.
    expect([0, 2_000_000, 2_500_000, 3_000_000, 4_500_000, 6_000_000, 7_000_000, 9_000_000].map((time) => atTime?.(time))).toEqual([0, 0, 0.5, 1, 1.5, 3, 3.5, 4]);
    expect(scaleOf("steps", line, undefined, false).atTime).toBe(undefined);
    expect(scaleOf("steps", { ...line, first: 20, last: 23 }, times, false).atTime).toBe(undefined);
  });
});
