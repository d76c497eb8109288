// What the page of a phone decides.
import { describe, expect, it } from "vitest";
import { activityOf, wordsOf } from "../../shared/pendant/activity";
import { freeName, isPoseName, keyOfPose, poseNames, positionIn, readPose } from "../../shared/pendant/poses";
import { hashOf, kMoveParts, kViews, placeOf } from "../../shared/pendant/view";

describe("the view of the page", () => {
  it("is in the fragment of its address", () => {
    for (const view of kViews) expect(placeOf(hashOf({ view, part: "joints" })).view).toBe(view);
    for (const part of kMoveParts) expect(placeOf(hashOf({ view: "move", part }))).toEqual({ view: "move", part });
  });

  it.each(["", "#", "#other", "#Move", "#code=abc"])("is what tasks show at `%s`", (hash) => {
    expect(placeOf(hash).view).toBe("show");
  });

  it.each(["#move", "#move/", "#move/other"])("has the first part at `%s`", (hash) => {
    expect(placeOf(hash)).toEqual({ view: "move", part: "joints" });
  });
});

describe("taught poses", () => {
  const q = [0, -0.35, 0, 1.6, 0, -1.19, 0];

  it("are those keys of the database that name one, in the order in which people count", () => {
    expect(poseNames(["o_t_c", "pose_b", "pose_pose10", "pose_pose2", "pose_", "pose_no name", 7])).toEqual(["b", "pose2", "pose10"]);
    expect(poseNames(null)).toEqual([]);
  });

  it("have the joints to which the arm goes", () => {
    expect(readPose("a", { pose: {}, q })).toEqual({ name: "a", q });
  });

  it.each([null, 7, [], {}, { q: 1 }, { q: q.slice(1) }, { q: [...q, 0] }, { q: [...q.slice(1), "0"] }, { q: [...q.slice(1), null] }])("are none without: %j", (value) => {
    expect(readPose("a", value)).toBeUndefined();
  });

  it("have the place of the tool, as the state of a robot has, in metres", () => {
    const place = { pose: { position: [0.45, -0.2, 0], orientation: [1, 0, 0, 0] } };
    expect(positionIn({ ...place, q })).toEqual([0.45, -0.2, 0]);
    expect(positionIn({ ...place, joints: {}, mode: "idle" })).toEqual([0.45, -0.2, 0]);
  });

  it.each([null, 7, [], {}, { pose: null }, { pose: [0, 0, 0] }, { position: [1, 2, 3] }, ...[null, "0, 0, 0", { x: 0 }, [], [1, 2], [1, 2, 3, 4], [1, 2, "3"], [null, 1, 2, 3], [1, 2, Number.NaN], [1, 2, Infinity]].map((position) => ({ pose: { position } }))])(
    "have none that is no three numbers: %j",
    (value) => {
      expect(positionIn(value)).toBeUndefined();
    },
  );

  it("get a name that is free", () => {
    expect(freeName([])).toBe("pose1");
    expect(freeName(["pose1", "pose3"])).toBe("pose2");
    expect(isPoseName(freeName(["pose1"]))).toBe(true);
    expect(poseNames([keyOfPose("pose1")])).toEqual(["pose1"]);
  });

  it.each(["", "a b", "ä", "x".repeat(33), "../a"])("have no name like `%s`", (name) => {
    expect(isPoseName(name)).toBe(false);
  });
});

describe("what a run does now", () => {
  it.each([["SearchObject", "Search object"], ["place_area", "Place area"], ["GetTCPPose", "Get TCP pose"], ["Pick", "Pick"], ["X1Move", "X1 move"]])("is told in words: %s", (name, words) => {
    expect(wordsOf(name)).toBe(words);
  });

  it("is the innermost of what is active, with where it is and how much goes on beside", () => {
    expect(activityOf({ active: ["Root", "Root/Task", "Root/Task/PickPart", "Root/Task/PickPart/Grasp", "Root/Watch"] })).toEqual({ within: ["Task", "Pick part"], now: "Grasp", others: 1 });
  });

  it("is the task itself where it has no active child", () => {
    expect(activityOf({ active: ["Root"] })).toEqual({ within: [], now: "Root", others: 0 });
  });

  it("is nothing where nothing is active", () => {
    expect(activityOf({ active: [] })).toBeUndefined();
  });
});
