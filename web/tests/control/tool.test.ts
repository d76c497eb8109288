// What is said of the tool while the arm is moved by hand.
import { expect, it } from "vitest";
import type { HostedService } from "../../generated/messages";
import { toolOf, toolWarning } from "../../shared/control/tool";

const gripper = (key: string, name: string, available = true): Pick<HostedService, "key" | "available" | "rsm"> => ({ key, available, rsm: { rsm: 1, name, operations: [{ name: "grasp" }, { name: "release" }], events: [] } });
const before = toolOf([gripper("gripper", "WSG 50")]);

it("nothing is said of the same tool, nor where there was none", () => {
  expect(before).toEqual({ key: "gripper", name: "WSG 50" });
  expect(toolWarning(before, [gripper("gripper", "WSG 50")])).toBeUndefined();
  expect(toolWarning(undefined, [])).toBeUndefined();
});

it("that its service is gone is said, by its key", () => {
  expect(toolWarning(before, [gripper("gripper", "WSG 50", false)])).toMatch(/^The gripper is not connected any more \(gripper\)/);
  expect(toolWarning(before, [])).toMatch(/not connected any more/);
});

it("that it is another one is said, by both names", () => {
  expect(toolWarning(before, [gripper("gripper", "Suction")])).toMatch(/^Another gripper is at the arm: Suction instead of WSG 50/);
  expect(toolWarning(before, [gripper("gripper", "WSG 50", false), gripper("hand", "Hand")])).toMatch(/Hand instead of WSG 50/);
});
