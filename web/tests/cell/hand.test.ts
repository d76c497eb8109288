// A hand of the page, against a server that notes what it is told.
import { describe, expect, it } from "vitest";
import { createHand } from "../../shared/cell/hand";
import { absentParts, forceText, lineEnd } from "../../shared/cell/touch";
import type { PersonCommand } from "../../shared/messages/person";
import type { Pose } from "../../shared/messages/pose";

function stage(answer: (act: PersonCommand) => Promise<unknown> = async () => undefined) {
  const told: PersonCommand[] = [];
  const refused: unknown[] = [];
  const waiting: (() => void)[] = [];
  const hand = createHand({
    name: "mine",
    act: (act) => (told.push(act), answer(act)),
    wait: () => new Promise((resolve) => waiting.push(resolve)),
    onRefused: (error) => refused.push(error),
  });
  const settle = async () => {
    for (let i = 0; i < 20; ++i) await Promise.resolve();
  };
  const tick = async () => {
    await settle();
    waiting.splice(0).forEach((go) => go());
    await settle();
  };
  return { hand, told, refused, tick };
}

describe("a hand", () => {
  it("grabs, draws towards the newest target only, and lets go", async () => {
    const { hand, told, tick } = stage();
    const over = hand.grab("link_5", [0, 0, 0.1]);
    await tick();
    hand.drag([0, 0, 1]);
    hand.drag([0, 0.1, 1]);
    await tick();
    hand.release();
    await tick();
    await over;
    expect(told).toEqual([
      { act: "grab", hand: "mine", body: "link_5", point: [0, 0, 0.1] },
      { act: "drag", hand: "mine", to: [0, 0.1, 1] },
      { act: "release", hand: "mine" },
    ]);
  });

  it("tells again and again that it is there while nothing moves", async () => {
    const { hand, told, tick } = stage();
    void hand.grab("cube", [0, 0, 0]);
    hand.drag([0, 0, 1]);
    for (let i = 0; i < 4; ++i) await tick();
    expect(told.filter(({ act }) => act === "drag").length).toBeGreaterThanOrEqual(4);
  });

  it("takes hold again when the server has taken the page for gone", async () => {
    let lost = true;
    const { hand, told, refused, tick } = stage(async ({ act }) => {
      if (act === "drag" && lost) throw new Error("the hand holds nothing");
      if (act === "grab" && told.length > 1) lost = false;
    });
    void hand.grab("cube", [0, 0, 0]);
    hand.drag([0, 0, 1]);
    await tick();
    expect(told.map(({ act }) => act).slice(0, 4)).toEqual(["grab", "drag", "grab", "drag"]);
    expect(refused).toEqual([]);
  });

  it("holds nothing after a refusal, and says why", async () => {
    const { hand, told, refused, tick } = stage(async () => {
      throw new Error("cannot be moved");
    });
    await hand.grab("table", [0, 0, 0]);
    hand.release();
    await tick();
    expect(refused).toEqual([new Error("cannot be moved")]);
    expect(told).toHaveLength(1);
  });
});

describe("a touch", () => {
  it("is shown as a line to its target, or along its push", () => {
    expect(lineEnd({ hand: "h", body: "b", at: [0, 0, 0], force: [0, 3, 4], target: [1, 1, 1] })).toEqual([1, 1, 1]);
    expect(lineEnd({ hand: "push", body: "b", at: [0, 0, 1], force: [0, 0, 50] })).toEqual([0, 0, 1.1]);
    expect(forceText({ hand: "h", body: "b", at: [0, 0, 0], force: [0, 3, 4] })).toBe("5 N");
  });

  it("of a part that was taken away is none: the pose does not have it", () => {
    const pose: Pose = { position: [0, 0, 0], orientation: [0, 0, 0, 1] };
    const body = (name: string, fixed: boolean) => ({ name, fixed, pose, shape: { kind: "sphere" as const, radius: 1 } });
    const bodies = [body("table", true), body("cube", false), body("can", false)];
    expect(absentParts(bodies, { time: 0, joints: {}, bodies: { can: pose }, hands: [] })).toEqual(["cube"]);
  });
});
