import { describe, expect, it } from "vitest";
import type { Timing } from "../../generated/messages";
import { runTimes } from "../../shared/mcap/runTimes";
import { worldClock } from "../../shared/mcap/worldClock";

const timing = (steps: Timing["steps"], services: Timing["services"] = []): Timing => ({ steps, services, until: 0 });

describe("the times of a run", () => {
  const times = runTimes({ steps: 5, created: 1000, ended: 1009 }, [timing([{ step: 1, time: 1000 }, { step: 2, time: 3000, arrived: 2900 }]), timing([{ step: 4, time: 7000 }])]);
  const ofAll = (ask: (step: number) => unknown) => [0, 1, 2, 3, 4, 5, 6].map(ask);
  it("are those that are recorded, else that of the macro step before", () => expect(ofAll(times.began)).toEqual([0, 1000, 3000, 3000, 7000, 7000, 7000]));
  it("say which are recorded", () => {
    expect(ofAll(times.isTimed)).toEqual([false, true, true, false, true, false, false]);
    expect(times.untimed).toBe(2);
  });
  it("say when the next one began that is recorded, and at last when the run was over", () => expect(ofAll(times.next)).toEqual([1000, 3000, 7000, 7000, 9000, 9000, 9000]));
  it("say when inputs had come", () => expect(ofAll(times.arrived)).toEqual([undefined, undefined, 2900, undefined, undefined, undefined, undefined]));
  it("never fall, and have no end before the last of them", () => {
    const fallen = runTimes({ steps: 2, created: 0, ended: 3 }, [timing([{ step: 1, time: 5000 }, { step: 2, time: 4000 }])]);
    expect([fallen.began(1), fallen.began(2), fallen.next(2)]).toEqual([5000, 5000, 5000]);
    expect(runTimes({ steps: 1, created: 0 }, []).next(1)).toBe(Infinity);
  });
  it("have each change of a service once, though each answer begins with the states", () => {
    const [idle, busy, away] = [{ service: "a", time: 0, state: "Idle" }, { service: "a", time: 5, state: "Busy" }, { service: "a", time: 9 }];
    const both = [timing([], [idle, { service: "b", time: 3, state: "On" }, busy]), timing([], [idle, busy, { ...busy, time: 7 }, away])];
    expect(runTimes({ steps: 0, created: 0 }, both).services).toEqual([idle, { service: "b", time: 3, state: "On" }, busy, away]);
  });
  it("have no change of a service after the end", () => {
    const changes = [1000, 2000, 2001].map((time, i) => ({ service: "a", time, state: String(i) }));
    expect(runTimes({ steps: 0, created: 5, ended: 7 }, [timing([], changes)]).services).toEqual(changes.slice(0, 2));
  });
});

describe("the world's clock on that of a run", () => {
  const times = runTimes({ steps: 2, created: 0, ended: 3000 }, [timing([{ step: 1, time: 1_000_000 }, { step: 2, time: 2_000_000 }])]);
  it("has the offset that the macro steps allow, and says how far it may be off", () => {
    // The world began 9 s before the run: 10.0 and 10.9 are in macro step 1, 11.1 is in the next one.
    const clock = worldClock([{ step: 1, time: 10 }, { step: 1, time: 10.9 }, { step: 2, time: 11.1 }], times);
    expect([10, 10.9].map((time) => clock.at({ step: 1, time }))).toEqual([1_050_000, 1_950_000]);
    expect(clock.at({ step: 2, time: 11.1 })).toBe(2_150_000);
    expect(clock.doubt).toBeCloseTo(50_000, 3);
  });
  it("leaves nothing outside the macro step with which it was recorded", () => {
    const clock = worldClock([{ step: 1, time: 10 }, { step: 2, time: 10.5 }], times);
    expect(clock.at({ step: 1, time: 14 })).toBe(2_000_000);
    expect(clock.at({ step: 2, time: 3 })).toBe(2_000_000);
    expect(clock.at({ step: 2, time: 99 })).toBe(3_000_000);
  });
  it("begins anew with a world that came back", () => {
    const clock = worldClock([{ step: 1, time: 500 }, { step: 1, time: 500.8 }, { step: 2, time: 0.1 }, { step: 2, time: 1 }], times);
    const [a, b, c, d] = [{ step: 1, time: 500 }, { step: 1, time: 500.8 }, { step: 2, time: 0.1 }, { step: 2, time: 1 }].map(clock.at);
    expect([(b ?? 0) - (a ?? 0), (d ?? 0) - (c ?? 0)]).toEqual([800_000, 900_000]);
    expect(c).toBeGreaterThanOrEqual(2_000_000);
  });
  it("begins with the first macro step, if nothing says when the run was over", () => {
    const open = runTimes({ steps: 1, created: 0 }, [timing([{ step: 1, time: 1_000_000 }])]);
    const clock = worldClock([{ step: 1, time: 7 }, { step: 1, time: 8 }], open);
    expect([clock.at({ step: 1, time: 7 }), clock.at({ step: 1, time: 8 }), clock.doubt]).toEqual([1_000_000, 2_000_000, Infinity]);
  });
});
