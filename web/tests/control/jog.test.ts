// What a button asks of a robot, and what is said of it.
import { describe, expect, it } from "vitest";
import type { HostedService } from "../../generated/messages";
import { angleText, armAngles, jogOf, kFirstShare, movableOf, speedText, standing } from "../../shared/control/jog";

describe("the velocity of a button", () => {
  it("is that of one joint, or of the tool along or around an axis", () => {
    expect(jogOf({ kind: "joint", joint: 2 }, -1, 0.5, "o")).toEqual({ joints: [0, 0, -0.4, 0, 0, 0, 0] });
    expect(jogOf({ kind: "linear", axis: "z" }, 1, 1, "o")).toEqual({ linear: [0, 0, 0.25], frame: "o" });
    expect(jogOf({ kind: "angular", axis: "x" }, 1, 0.5, "tool")).toEqual({ angular: [0.4, 0, 0], frame: "tool" });
  });
  it("is nothing once it stands", () => {
    expect(standing(jogOf({ kind: "joint", joint: 0 }, 1, 1, "o"))).toEqual({ joints: [0, 0, 0, 0, 0, 0, 0] });
    expect(standing({ angular: [1, 2, 3], frame: "tool" })).toEqual({ angular: [0, 0, 0], frame: "tool" });
    expect(standing({ linear: [1, 2, 3], frame: "o" })).toEqual({ linear: [0, 0, 0], frame: "o" });
  });
  it("is slow at first, and told", () => {
    expect([kFirstShare, speedText(0.1), speedText(1)]).toEqual([0.1, "10 %: 25 mm/s, 4.6 °/s", "100 %: 250 mm/s, 45.8 °/s"]);
  });
});

describe("the angles of an arm", () => {
  const seven = { a1: 0, a2: 1, a3: 2, a4: 3, a5: 4, a6: 5, a7: 6 };
  it("are those of the joints that are numbered", () => {
    expect(armAngles({ finger_left: 9, ...seven })).toEqual([0, 1, 2, 3, 4, 5, 6]);
    expect([armAngles({}), armAngles({ a1: 0, a7: 0 })]).toEqual([[], []]);
  });
  it("are in degrees; without an arm there is none", () => expect([Math.PI / 2, -0.01, -0.0001, undefined].map(angleText)).toEqual(["90.0°", "-0.6°", "0.0°", "–"]));
});

describe("what is moved by hand", () => {
  const service = (key: string, ...names: readonly string[]): Pick<HostedService, "key" | "available" | "rsm"> => ({ key, available: true, rsm: { rsm: 1, name: key, operations: names.map((name) => ({ name })), events: [] } });
  it("is a robot that jogs, and a gripper", () => {
    expect(movableOf([service("camera", "look"), service("robot", "move", "jog", "stop"), service("gripper", "grasp", "release")])).toEqual({ robot: "robot", gripper: { key: "gripper", open: "release", close: "grasp" } });
    expect(movableOf([service("robot", "move", "stop"), service("hand", "open", "close")])).toEqual({ robot: undefined, gripper: { key: "hand", open: "open", close: "close" } });
  });
  it("is nothing that is not there now", () => expect(movableOf([{ ...service("robot", "jog", "stop"), available: false }])).toEqual({ robot: undefined, gripper: undefined }));
});
