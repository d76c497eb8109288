// When the cell is drawn again.
import { describe, expect, it } from "vitest";
import { looksDifferent, restAfter } from "../../shared/cell/pace";
import type { CellPose } from "../../generated/messages";

const still: CellPose = {
  time: 1,
  joints: { a1: 0.5 },
  bodies: { Cube: { position: [0.4, 0, 0.1], orientation: [0, 0, 0, 1] } },
  hands: [],
};
const cube = (position: readonly [number, number, number]): CellPose => ({ ...still, bodies: { Cube: { position, orientation: [0, 0, 0, 1] } } });

describe("looksDifferent", () => {
  it("is false while only time passes, or something trembles by less than a pixel", () => {
    expect(looksDifferent(still, { ...still, time: 9 })).toBe(false);
    expect(looksDifferent(still, { ...still, joints: { a1: 0.50001 } })).toBe(false);
    expect(looksDifferent(still, cube([0.40001, 0, 0.1]))).toBe(false);
  });
  it("is true for a joint, a part that was shifted or turned, taken away or put in", () => {
    expect(looksDifferent(still, { ...still, joints: { a1: 0.501 } })).toBe(true);
    expect(looksDifferent(still, cube([0.4, 0, 0.101]))).toBe(true);
    expect(looksDifferent(still, { ...still, bodies: { Cube: { position: [0.4, 0, 0.1], orientation: [0, 0, 0.01, 1] } } })).toBe(true);
    expect(looksDifferent(still, { ...still, bodies: {} })).toBe(true);
    expect(looksDifferent({ ...still, bodies: {} }, still)).toBe(true);
  });
  it("is true while a hand holds, and once more when it has let go", () => {
    const held: CellPose = { ...still, hands: [{ hand: "right", body: "gripper", at: [0, 0, 0], force: [1, 0, 0] }] };
    expect(looksDifferent(still, held)).toBe(true);
    expect(looksDifferent(held, held)).toBe(true);
    expect(looksDifferent(held, still)).toBe(true);
  });
});

describe("restAfter", () => {
  it("does not hold up a frame that a GPU has made", () => {
    expect(restAfter(16)).toBe(0);
  });
  it("leaves most of the time to the rest of the page where frames take long, but never stops", () => {
    expect(restAfter(60)).toBe(120);
    expect(restAfter(5000)).toBe(1000);
  });
});
