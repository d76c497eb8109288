import { describe, expect, it } from "vitest";
import { linkFrames, type Joint, type Robot } from "../../shared/mcap/robot";
import { ofRollPitchYaw, rotated, turn, type Quaternion, type Vector } from "../../shared/mcap/rotation";

const quarter = Math.PI / 2;
const none: Quaternion = [0, 0, 0, 1];
const near = (found: readonly number[] | undefined, wanted: readonly number[]) => expect(found?.map((each, i) => Math.abs(each - (wanted[i] ?? NaN)) < 1e-12)).toEqual(wanted.map(() => true));
const joint = (kind: Joint["kind"], name: string, parent: string, child: string, position: Vector, orientation = none): Joint => ({ name, kind, parent, child, origin: { position, orientation }, axis: [0, 0, 2] });

describe("rotations", () => {
  it("turn by the right hand", () => near(rotated(turn([0, 0, 3], quarter), [1, 0, 0]), [0, 1, 0]));
  it("of roll, pitch and yaw are one after the other around fixed axes", () => {
    near(rotated(ofRollPitchYaw([quarter, 0, quarter]), [0, 1, 0]), [0, 0, 1]);
    near(rotated(ofRollPitchYaw([0, quarter, quarter]), [1, 0, 0]), [0, 0, -1]);
    near(rotated(ofRollPitchYaw([quarter, 0, quarter]), [0, 0, 1]), [1, 0, 0]);
  });
});

describe("the frames of a robot", () => {
  const robot: Robot = {
    base: { position: [1, 2, 3], orientation: none },
    root: "base",
    joints: [
      joint("turns", "a1", "base", "link", [0, 0, 0.1], turn([1, 0, 0], quarter)),
      joint("slides", "jaw", "link", "finger", [0, 0.5, 0], turn([1, 0, 0], quarter)),
      joint("fixed", "mount", "finger", "tool", [0, 0, 0.2]),
    ],
  };
  const frames = linkFrames(robot, { a1: quarter, jaw: 0.3 });
  it("begin with the base in the world, and place each link in the one before", () => {
    expect(frames.map(({ parent, child }) => `${parent}>${child}`)).toEqual(["world>base", "base>link", "link>finger", "finger>tool"]);
    expect(frames[0]?.pose).toBe(robot.base);
  });
  it("turn around the axis in the frame of the link", () => {
    near(frames[1]?.pose.position, [0, 0, 0.1]);
    near(rotated(frames[1]?.pose.orientation ?? none, [1, 0, 0]), [0, 0, 1]);
  });
  it("slide along it, by metres", () => near(frames[2]?.pose.position, [0, 0.2, 0]));
  it("leave fixed joints as they are", () => expect(frames[3]?.pose).toEqual({ position: [0, 0, 0.2], orientation: none }));
  it("are none if the position of a joint is not recorded", () => expect(linkFrames(robot, { a1: 0 })).toEqual([]));
});
