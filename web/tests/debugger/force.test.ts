import { describe, expect, it } from "vitest";
import { proposalText, reasonAgainstForce, typedValue } from "../../shared/debugger/force";
import { operationChoices, operationKey } from "../../shared/debugger/operations";
import { writeExact } from "../../shared/edit/exact";
import type { Core, HostedService } from "../../generated/messages";

describe("forcing", () => {
  it("sends numbers as they were written", () => {
    const typed = typedValue('[1.0, 2, "a"]');
    expect("value" in typed && writeExact(typed.value)).toBe('[1.0,2,"a"]');
  });
  it("says what is no value", () => expect(typedValue("par.x + ")).toHaveProperty("reason"));
  it("says what would be done", () => {
    expect(proposalText({ path: "Root/A", scope: "port", name: "done" })).toBe("Leave A through done?");
    expect(proposalText({ path: "Root/A", scope: "par", name: "speed", text: "1" })).toBe("Set the parameter speed of A to");
  });
  it("is possible between macro steps of a run that is running", () => {
    const core: Core = { id: "1", document: "t", revision: 1, status: "running", paused: true, stepping: false, step: 1, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };
    expect(reasonAgainstForce(core)).toBeUndefined();
    for (const other of [undefined, { ...core, micro: 2 }, { ...core, status: "ended" as const }]) expect(reasonAgainstForce(other)).toBeDefined();
  });
});

describe("operationChoices", () => {
  const operation = (name: string) => ({ name }) as HostedService["rsm"]["operations"][number];
  const services = [{ key: "robot", rsm: { operations: [operation("move"), operation("stop")] } as unknown as HostedService["rsm"] }];
  const texts = (chosen: { readonly service?: string; readonly operation?: string }) => operationChoices(services, chosen).map(({ text }) => text);
  it("has any, any of a service, and each operation", () => expect(texts({})).toEqual(["any operation", "any of robot", "robot.move", "robot.stop"]));
  it("has what was chosen, though its service is not there", () => expect(texts({ service: "gone", operation: "do" }).at(-1)).toBe("gone.do"));
  it("has another key for each", () => expect(new Set(operationChoices(services, {}).map(operationKey)).size).toBe(4));
});
