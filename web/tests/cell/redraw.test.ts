// When the cell is drawn again.
import { describe, expect, it } from "vitest";
import { looksDifferent, pauseAfter } from "../../shared/cell/redraw";
import type { CellPose } from "../../generated/messages";

const still: CellPose = {
  time: 1,
  joints: { a1: 0.5 },
  bodies: { Cube: { position: [0.4, 0, 0.1], orientation: [0, 0, 0, 1] } },
  hands: [],
};
const cube = (position: readonly [number, number, number]): CellPose => ({ ...still, bodies: { Cube: { position, orientation: [0, 0, 0, 1] } } });

describe("looksDifferent", () => {
  it("is false while only time passes, or for movements of less than a pixel", () => {
    expect(looksDifferent(still, { ...still, time: 9 })).toBe(false);
    expect(looksDifferent(still, { ...still, joints: { a1: 0.50001 } })).toBe(false);
    expect(looksDifferent(still, cube([0.40001, 0, 0.1]))).toBe(false);
  });
  it("is true for a joint that moves and a part that is moved, turned, removed or added", () => {
    expect(looksDifferent(still, { ...still, joints: { a1: 0.501 } })).toBe(true);
    expect(looksDifferent(still, cube([0.4, 0, 0.101]))).toBe(true);
    expect(looksDifferent(still, { ...still, bodies: { Cube: { position: [0.4, 0, 0.1], orientation: [0, 0, 0.01, 1] } } })).toBe(true);
    expect(looksDifferent(still, { ...still, bodies: {} })).toBe(true);
    expect(looksDifferent({ ...still, bodies: {} }, still)).toBe(true);
  });
  it("is true while a hand holds, and once more after its release", () => {
    const held: CellPose = { ...still, hands: [{ hand: "right", body: "gripper", at: [0, 0, 0], force: [1, 0, 0] }] };
    expect(looksDifferent(still, held)).toBe(true);
    expect(looksDifferent(held, held)).toBe(true);
    expect(looksDifferent(held, still)).toBe(true);
  });
});

describe("pauseAfter", () => {
  it("does not delay fast frames", () => {
    expect(pauseAfter(16)).toBe(0);
  });
  it("leaves most of the time to the rest of the page when frames are slow, but never stops", () => {
    expect(pauseAfter(60)).toBe(120);
    expect(pauseAfter(5000)).toBe(1000);
  });
});
