// A hand of the page, against a server that records commands.
import { describe, expect, it } from "vitest";
import { createHand } from "../../shared/cell/hand";
import { absentParts, forceText, lineEnd } from "../../shared/cell/touch";
import type { PersonCommand, Pose } from "../../generated/messages";

function fixture(answer: (command: PersonCommand) => Promise<unknown> = () => Promise.resolve()) {
  const sent: PersonCommand[] = [];
  const refused: unknown[] = [];
  const waiting: (() => void)[] = [];
  const hand = createHand({
    name: "mine",
    send: (command) => (sent.push(command), answer(command)),
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
  return { hand, sent, refused, tick };
}

describe("a hand", () => {
  it("grabs, drags to the newest target only, and releases", async () => {
    const { hand, sent, tick } = fixture();
    const over = hand.grab("link_5", [0, 0, 0.1]);
    await tick();
    hand.drag([0, 0, 1]);
    hand.drag([0, 0.1, 1]);
    await tick();
    hand.release();
    await tick();
    await over;
    expect(sent).toEqual([
      { act: "grab", hand: "mine", body: "link_5", point: [0, 0, 0.1] },
      { act: "drag", hand: "mine", to: [0, 0.1, 1] },
      { act: "release", hand: "mine" },
    ]);
  });

  it("repeats its target while nothing moves", async () => {
    const { hand, sent, tick } = fixture();
    void hand.grab("cube", [0, 0, 0]);
    hand.drag([0, 0, 1]);
    for (let i = 0; i < 4; ++i) await tick();
    expect(sent.filter(({ act }) => act === "drag").length).toBeGreaterThanOrEqual(4);
  });

  it("grabs again when the server has released it", async () => {
    let lost = true;
    const { hand, sent, refused, tick } = fixture(({ act }) => {
      if (act === "drag" && lost) return Promise.reject(new Error("the hand holds nothing"));
      if (act === "grab" && sent.length > 1) lost = false;
      return Promise.resolve();
    });
    void hand.grab("cube", [0, 0, 0]);
    hand.drag([0, 0, 1]);
    await tick();
    expect(sent.map(({ act }) => act).slice(0, 4)).toEqual(["grab", "drag", "grab", "drag"]);
    expect(refused).toEqual([]);
  });

  it("holds nothing after a refusal, and says why", async () => {
    const { hand, sent, refused, tick } = fixture(() => Promise.reject(new Error("cannot be moved")));
    await hand.grab("table", [0, 0, 0]);
    hand.release();
    await tick();
    expect(refused).toEqual([new Error("cannot be moved")]);
    expect(sent).toHaveLength(1);
  });
});

describe("a touch", () => {
  it("is shown as a line to its target, or along its push", () => {
    expect(lineEnd({ hand: "h", body: "b", at: [0, 0, 0], force: [0, 3, 4], target: [1, 1, 1] })).toEqual([1, 1, 1]);
    expect(lineEnd({ hand: "push", body: "b", at: [0, 0, 1], force: [0, 0, 50] })).toEqual([0, 0, 1.1]);
    expect(forceText({ hand: "h", body: "b", at: [0, 0, 0], force: [0, 3, 4] })).toBe("5 N");
  });

  it("cannot be of a part that was removed: the pose does not have it", () => {
    const pose: Pose = { position: [0, 0, 0], orientation: [0, 0, 0, 1] };
    const body = (name: string, fixed: boolean) => ({ name, fixed, pose, shape: { sphere: 1 } });
    const bodies = [body("table", true), body("cube", false), body("can", false)];
    expect(absentParts(bodies, { time: 0, joints: {}, bodies: { can: pose }, hands: [] })).toEqual(["cube"]);
  });
});
