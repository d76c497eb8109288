// A motion while a button is held.
import { describe, expect, it } from "vitest";
import { createHeldMotion, goingTo, jogging, kGuiding, kMostLate, kMostUnanswered, kRepeat } from "../../shared/control/heldMotion";

const up = { linear: [0, 0, 0.02], frame: "o" } as const;

function fixture(answer: () => Promise<unknown> = () => Promise.resolve(null)) {
  const calls: { readonly operation: string; readonly kwargs: unknown }[] = [];
  const refused: string[] = [];
  let timers: readonly (() => void)[] = [];
  let done = 0;
  const motion = createHeldMotion({
    call: (operation, kwargs) => {
      calls.push({ operation, kwargs });
      return answer();
    },
    every: (time, act) => {
      expect(time).toBe(kRepeat);
      timers = [...timers, act];
      return () => (timers = timers.filter((each) => each !== act));
    },
    onRefused: (why) => void refused.push(why),
    onDone: () => void done++,
  });
  return {
    motion, calls, refused, timers: () => timers.length, done: () => done,
    async tick() {
      timers.forEach((act) => act());
      for (let i = 0; i < 5; i++) await Promise.resolve();
    },
  };
}

describe("a held button", () => {
  it("moves at once, and anew in time: the robot stops 0.25 s after the last call", async () => {
    const f = fixture();
    f.motion.start(jogging(up));
    for (let i = 0; i < 3; i++) await f.tick();
    expect(f.calls).toEqual(Array(4).fill({ operation: "jog", kwargs: up }));
    expect(kRepeat * 3).toBeLessThan(250);
  });

  it("ends the motion at once: it stands, and the robot is told to stop", async () => {
    const f = fixture();
    f.motion.start(jogging({ joints: [0.1, 0, 0, 0, 0, 0, 0] }));
    f.motion.end();
    f.motion.end();
    await f.tick();
    expect(f.calls.slice(1)).toEqual([{ operation: "jog", kwargs: { joints: [0, 0, 0, 0, 0, 0, 0] } }, { operation: "stop", kwargs: {} }]);
    expect([f.timers(), f.motion.isMoving()]).toEqual([0, false]);
  });

  it("takes the place of another one, which ends before", () => {
    const f = fixture();
    f.motion.start(jogging(up));
    f.motion.start(jogging({ angular: [1, 0, 0], frame: "tool" }));
    expect(f.calls.map(({ operation }) => operation)).toEqual(["jog", "jog", "stop", "jog"]);
    expect(f.timers()).toBe(1);
  });

  it("gives up when the robot refuses, and says why", async () => {
    const f = fixture(() => Promise.reject(new Error("joint 2 is at its limit")));
    f.motion.start(jogging(up));
    await f.tick();
    expect([f.refused, f.timers(), f.motion.isMoving()]).toEqual([["joint 2 is at its limit"], 0, false]);
  });

  it("says nothing of a refusal that comes after it was let go", async () => {
    const f = fixture(() => Promise.reject(new Error("stopped")));
    f.motion.start(jogging(up));
    f.motion.end();
    await f.tick();
    expect(f.refused).toEqual([]);
  });

  it("calls no more often than is answered", async () => {
    const f = fixture(() => new Promise(() => undefined));
    f.motion.start(jogging(up));
    for (let i = 0; i < 10; i++) await f.tick();
    expect(f.calls).toHaveLength(kMostUnanswered);
  });

  it("ends when nothing is answered any more, and says so", async () => {
    const f = fixture(() => new Promise(() => undefined));
    f.motion.start(kGuiding);
    for (let i = 0; i < kMostUnanswered - 1 + kMostLate - 1; i++) await f.tick();
    expect(f.refused).toEqual([]);
    await f.tick();
    expect([f.refused, f.timers(), f.calls.at(-1)?.operation]).toEqual([["the server does not answer"], 0, "stop"]);
  });

  it("guides as long as it is called anew, and has nothing to say when it ends but stop", async () => {
    const f = fixture();
    f.motion.start(kGuiding);
    await f.tick();
    f.motion.end();
    expect(f.calls.map(({ operation }) => operation)).toEqual(["guide", "guide", "stop"]);
  });
});

describe("a button that is held until the arm has arrived", () => {
  const target = [0, -0.35, 0, 1.6, 0, -1.19, 0];

  it("calls the motion once, and says that it is done", async () => {
    let arrive = (): void => undefined;
    const f = fixture(() => new Promise<void>((resolve) => (arrive = resolve)));
    f.motion.start(goingTo(target, 0.1));
    await f.tick();
    expect([f.calls, f.timers(), f.done()]).toEqual([[{ operation: "move", kwargs: { target: { joints: target }, speed: 0.1, acceleration: 0.1 } }], 0, 0]);
    arrive();
    await f.tick();
    expect([f.done(), f.motion.isMoving(), f.calls.length]).toEqual([1, false, 1]);
  });

  it("is refused at once while the server is late: it would be called no more", async () => {
    const f = fixture(() => new Promise(() => undefined));
    f.motion.start(kGuiding);
    for (let i = 0; i < kMostUnanswered; i++) await f.tick();
    f.motion.start(goingTo(target, 0.1));
    expect([f.refused, f.motion.isMoving()]).toEqual([["the server does not answer"], false]);
  });

  it("stops when it is let go on the way, and the answer to that is no news", async () => {
    let fail: (error: Error) => void = () => undefined;
    const f = fixture(() => new Promise<void>((_, reject) => (fail = reject)));
    f.motion.start(goingTo(target, 0.1));
    const stopped = fail;
    f.motion.end();
    stopped(new Error("stopped"));
    await f.tick();
    expect([f.calls.map(({ operation }) => operation), f.refused, f.done()]).toEqual([["move", "stop"], [], 0]);
  });
});
