// What the page says of an arm that is pulled or has collided, by what the robot tells.
import { describe, expect, it } from "vitest";
import { collisionText, controlOf, kMarked, markedCollision, whyItHolds, type Control } from "../../shared/cell/control";
import { pulledLink } from "../../shared/cell/touch";
import type { Body, CellPose } from "../../generated/messages";

const collision = { link: "link_6", severity: "medium", reaction: "stop", classification: "accidental", f_ext_hat: [0, -12, 5], time: 4 };
const still: Control = { time: 5, mode: "position", moving: false };

describe("controlOf", () => {
  it("reads what a robot says", () => {
    expect(controlOf({ time: 5, header: { mode: "position", moving: false, collision } })).toEqual({ ...still, collision });
    expect(controlOf({ time: 5, header: { mode: "cartesian_impedance", moving: true, force: 20 } })).toEqual({ time: 5, mode: "cartesian_impedance", moving: true, force: 20 });
  });
  it("takes no other packet, and no damaged collision", () => {
    for (const header of [null, 1, {}, { mode: "dancing", moving: true }, { mode: "position" }]) expect(controlOf({ time: 5, header })).toBeUndefined();
    expect(controlOf({ time: 5, header: { mode: "position", moving: false, collision: { ...collision, f_ext_hat: "much" } } })).toEqual(still);
  });
});

describe("markedCollision", () => {
  it("is the last one for some seconds", () => {
    expect(markedCollision({ ...still, collision })).toEqual(collision);
    expect(markedCollision({ ...still, collision, time: 4 + kMarked })).toEqual(collision);
    expect(markedCollision({ ...still, collision, time: 4.2 + kMarked })).toBeUndefined();
    expect(markedCollision(still)).toBeUndefined();
  });
  it("is not one of a world that was there before", () => expect(markedCollision({ ...still, collision, time: 1 })).toBeUndefined());
});

describe("collisionText", () => {
  it("names the link that felt it and claims no more than is known of place and force", () =>
    expect(collisionText(collision)).toBe("Collision felt at link_6 or beyond: medium, 13 N if at the tool"));
});

describe("whyItHolds", () => {
  it("says that nobody has asked an arm in position control to give way", () => {
    expect(whyItHolds(still)).toMatch(/^The arm holds its position: the task has not asked it to give way/);
    expect(whyItHolds({ ...still, moving: true })).toMatch(/^The arm follows its path and stops/);
  });
  it("says that it has braked, after a collision that stopped it", () => {
    expect(whyItHolds({ ...still, collision })).toMatch(/^The arm has braked after a collision\. The arm holds/);
    expect(whyItHolds({ ...still, collision: { ...collision, reaction: "none" } })).not.toMatch(/braked/);
  });
  it("says with what force a spring pulls back at most, if that is limited", () => {
    expect(whyItHolds({ ...still, mode: "cartesian_impedance", force: 20 })).toMatch(/goes back with at most 20 N/);
    expect(whyItHolds({ ...still, mode: "cartesian_impedance" })).not.toMatch(/ N/);
    expect(whyItHolds({ ...still, mode: "joint_impedance" })).toMatch(/like a spring/);
  });
  it("says nothing of an arm that goes with the hand", () => expect(whyItHolds({ ...still, mode: "gravity_compensation" })).toBeUndefined());
});

describe("pulledLink", () => {
  const bodies: readonly Body[] = [{ name: "cube", shape: { box: [1, 1, 1] }, pose: { position: [0, 0, 0], orientation: [0, 0, 0, 1] }, fixed: false }];
  const pose = (...hands: NonNullable<CellPose["hands"]>): CellPose => ({ time: 1, joints: {}, bodies: {}, hands });
  const hand = { hand: "right", at: [0, 0, 0], force: [1, 0, 0] } as const;
  it("is the link that a hand holds; no part, and not what a push meets", () => {
    expect(pulledLink(bodies, pose({ ...hand, body: "link_5", target: [0, 0, 1] }))).toBe("link_5");
    expect(pulledLink(bodies, pose({ ...hand, body: "cube", target: [0, 0, 1] }))).toBeUndefined();
    expect(pulledLink(bodies, pose({ ...hand, hand: "push", body: "link_5" }))).toBeUndefined();
    expect(pulledLink(bodies, { time: 1, joints: {}, bodies: {} })).toBeUndefined();
  });
});
