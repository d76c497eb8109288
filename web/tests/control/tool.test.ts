// What has become of the tool while the arm is moved by hand.
import { expect, it } from "vitest";
import type { HostedService } from "../../generated/messages";
import { toolChange, toolOf } from "../../shared/control/tool";

const gripper = (key: string, name: string, available = true): Pick<HostedService, "key" | "available" | "rsm"> => ({ key, available, rsm: { rsm: 1, name, operations: [{ name: "grasp" }, { name: "release" }], events: [] } });
const before = toolOf([gripper("gripper", "WSG 50")]);

it("nothing is said of the same tool, nor where there was none", () => {
  expect(before).toEqual({ key: "gripper", name: "WSG 50" });
  expect(toolChange(before, [gripper("gripper", "WSG 50")])).toBeUndefined();
  expect(toolChange(undefined, [])).toBeUndefined();
});

it("that its service is gone is said, by its key", () => {
  expect(toolChange(before, [gripper("gripper", "WSG 50", false)])).toMatchObject({ kind: "gone", before: { key: "gripper" } });
  expect(toolChange(before, [])).toMatchObject({ kind: "gone" });
});

it("that it is another one is said, by both names", () => {
  expect(toolChange(before, [gripper("gripper", "Suction")])).toMatchObject({ kind: "another", now: { name: "Suction" }, before: { name: "WSG 50" } });
  expect(toolChange(before, [gripper("gripper", "WSG 50", false), gripper("hand", "Hand")])).toMatchObject({ kind: "another", now: { name: "Hand" }, before: { name: "WSG 50" } });
});
