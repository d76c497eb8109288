// Words for the ways of the tool, and names of joints.
import { describe, expect, it } from "vitest";
import type { HostedService } from "../../generated/messages";
import { jointNames, wayName, wayOf } from "../../shared/control/directions";
import { jogOf, kToolParts } from "../../shared/control/jog";

describe("a way of the tool", () => {
  it("has a word as seen from the base of the robot, either way another one", () => {
    const words = kToolParts.flatMap((part) => [wayOf(part, 1, "o"), wayOf(part, -1, "o")]);
    expect(words.slice(0, 6)).toEqual(["Forward", "Back", "Left", "Right", "Up", "Down"]);
    expect(new Set(words).size).toBe(12);
  });

  it("has the word of where it leads: Z up is a velocity along +Z of the cell", () => {
    const part = { kind: "linear", axis: "z" } as const;
    expect([wayOf(part, 1, "o"), jogOf(part, 1, 1, "o")]).toEqual(["Up", { linear: [0, 0, 0.25], frame: "o" }]);
  });

  it("along the tool's own axes has one only where it points", () => {
    expect([wayOf({ kind: "linear", axis: "z" }, 1, "tool"), wayOf({ kind: "linear", axis: "x" }, 1, "tool"), wayOf({ kind: "angular", axis: "z" }, 1, "tool")]).toEqual(["Ahead", undefined, "Twist right"]);
  });

  it("is named by both, the word first", () => {
    expect(wayName({ kind: "linear", axis: "z" }, -1, "o")).toBe("Down, tool along Z minus");
    expect(wayName({ kind: "linear", axis: "x" }, 1, "tool")).toBe("Tool along X plus");
  });
});

describe("the names of joints", () => {
  const names = ["Base", "Shoulder", "Upper arm", "Elbow", "Forearm", "Wrist", "Flange"];
  const robot = (meta: unknown) => [{ key: "robot", available: true, rsm: { operations: [{ name: "jog" }, { name: "stop" }], meta } }] as unknown as readonly HostedService[];

  it("are those of the description of the robot", () => {
    expect(jointNames(robot({ joints: names }))).toEqual(names);
    expect(wayName({ kind: "joint", joint: 1 }, 1, "o", names)).toBe("Shoulder, joint 2 plus");
  });

  it.each([undefined, null, {}, { joints: "Base" }, { joints: names.slice(1) }, { joints: [...names.slice(1), 7] }, { joints: [...names.slice(1), " "] }])("are none where it has %j", (meta) => {
    expect(jointNames(robot(meta))).toEqual([]);
    expect(wayName({ kind: "joint", joint: 1 }, -1, "o", [])).toBe("Joint 2 minus");
  });
});
