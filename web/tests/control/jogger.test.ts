// A motion while a button is held.
import { describe, expect, it } from "vitest";
import { createJogger, kMostUnanswered, kRepeat } from "../../shared/control/jogger";

const up = { linear: [0, 0, 0.02], frame: "o" } as const;

function fixture(answer: () => Promise<unknown> = () => Promise.resolve(null)) {
  const calls: { readonly operation: string; readonly kwargs: unknown }[] = [];
  const refused: string[] = [];
  let timers: readonly (() => void)[] = [];
  const jogger = createJogger({
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
  });
  return {
    jogger, calls, refused, timers: () => timers.length,
    async tick() {
      timers.forEach((act) => act());
      for (let i = 0; i < 5; i++) await Promise.resolve();
    },
  };
}

describe("a held button", () => {
  it("moves at once, and anew in time: the robot stops 0.25 s after the last call", async () => {
    const f = fixture();
    f.jogger.start(up);
    for (let i = 0; i < 3; i++) await f.tick();
    expect(f.calls).toEqual(Array(4).fill({ operation: "jog", kwargs: up }));
    expect(kRepeat * 3).toBeLessThan(250);
  });

  it("ends the motion at once: it stands, and the robot is told to stop", async () => {
    const f = fixture();
    f.jogger.start({ joints: [0.1, 0, 0, 0, 0, 0, 0] });
    f.jogger.end();
    f.jogger.end();
    await f.tick();
    expect(f.calls.slice(1)).toEqual([{ operation: "jog", kwargs: { joints: [0, 0, 0, 0, 0, 0, 0] } }, { operation: "stop", kwargs: {} }]);
    expect([f.timers(), f.jogger.isMoving()]).toEqual([0, false]);
  });

  it("takes the place of another one, which ends before", () => {
    const f = fixture();
    f.jogger.start(up);
    f.jogger.start({ angular: [1, 0, 0], frame: "tool" });
    expect(f.calls.map(({ operation }) => operation)).toEqual(["jog", "jog", "stop", "jog"]);
    expect(f.timers()).toBe(1);
  });

  it("gives up when the robot refuses, and says why", async () => {
    const f = fixture(() => Promise.reject(new Error("joint 2 is at its limit")));
    f.jogger.start(up);
    await f.tick();
    expect([f.refused, f.timers(), f.jogger.isMoving()]).toEqual([["joint 2 is at its limit"], 0, false]);
  });

  it("says nothing of a refusal that comes after it was let go", async () => {
    const f = fixture(() => Promise.reject(new Error("stopped")));
    f.jogger.start(up);
    f.jogger.end();
    await f.tick();
    expect(f.refused).toEqual([]);
  });

  it("calls no more often than is answered", async () => {
    const f = fixture(() => new Promise(() => undefined));
    f.jogger.start(up);
    for (let i = 0; i < 10; i++) await f.tick();
    expect(f.calls).toHaveLength(kMostUnanswered);
  });
});
