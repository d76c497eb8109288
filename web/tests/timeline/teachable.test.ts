// Which poses of a step that has failed can be taught again, and whether a question is about that.
import { describe, expect, it } from "vitest";
import { posesToTeach, asksAbout } from "../../shared/timeline/teachable";
import type { Step, StepParameter } from "../../shared/timeline/timeLine";

const parameter = (name: string, domain: string, value: string): StepParameter => ({ about: { name, domain } as StepParameter["about"], value: { kind: "constant", state: "s", name, element: undefined, value } });
const stepOf = (...parameters: readonly StepParameter[]) => ({ parameters }) as unknown as Step;
const step = stepOf(parameter("pose", "pose", "above"), parameter("label", "label", "cube"));

describe("the poses that can be taught again", () => {
  it.each(["no_pose", "unreachable", "no_part", "collision", "blocked"])("are those of a step with the error %s", (port) => {
    expect(posesToTeach({ step, port })).toEqual(["above"]);
  });

  it.each(["busy", "stopped", "no_robot", "setting", "error"])("are none where %s has another reason", (port) => {
    expect(posesToTeach({ step, port })).toEqual([]);
  });

  it("are as the run was told, each once, and such that can be saved", () => {
    expect(posesToTeach({ step, port: "no_pose" }, { pose: "below" })).toEqual(["below"]);
    expect(posesToTeach({ step: stepOf(parameter("pose", "pose", "a"), parameter("to", "pose", "a"), parameter("from", "pose", "no name")), port: "no_pose" })).toEqual(["a"]);
  });
});

describe("the question what is to be done", () => {
  const buttons = ["Retry", "Skip", "Abort"];

  it("is known by its answers and by the step that has failed", () => {
    expect(asksAbout({ text: "Pick has failed: nothing red. What is to be done?", buttons }, "Pick")).toBe(true);
    expect(asksAbout({ text: `${"x".repeat(100)} has failed.`, buttons }, "x".repeat(120))).toBe(true);
  });

  it("is none of another step, or of another task, and no number", () => {
    expect(asksAbout({ text: "Place has failed.", buttons }, "Pick")).toBe(false);
    expect(asksAbout({ text: "Pick has failed.", buttons: ["Retry", "Abort"] }, "Pick")).toBe(false);
    expect(asksAbout({ text: "Pick has failed." }, "Pick")).toBe(false);
  });
});
