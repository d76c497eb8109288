import { describe, expect, it } from "vitest";
import type { Derivation, TraceStep } from "../../generated/messages";
import { stepRows } from "../../shared/derivation/stepRows";

const micro = {} as Derivation;
const event = (step: number, name: string, changes = false): TraceStep => ({
  step,
  input: { kind: "event", service: "robot", event: name, data: null } as TraceStep["input"],
  micro: changes ? [micro] : [],
  calls: [],
});
const steps = [event(1, "started", true), ...[2, 3, 4, 5].map((step) => event(step, "state")), event(6, "contact", true), event(7, "state"), event(8, "state")];
const told = (filter = "", shown?: number, opened: readonly number[] = []) =>
  stepRows(steps, filter, shown, new Set(opened)).map((row) => (row.kind === "idle" ? `${row.first}-${row.last}: ${row.count}` : row.step.step));

describe("the rows of macro steps", () => {
  it("have steps one after the other that changed nothing as one, if they are some", () => expect(told()).toEqual([1, "2-5: 4", 6, 7, 8]));
  it("tell them one by one where one of them is shown, or somebody has opened them", () => {
    expect(told("", 3)).toEqual([1, 2, 3, 4, 5, 6, 7, 8]);
    expect(told("", 1, [2])).toEqual([1, 2, 3, 4, 5, 6, 7, 8]);
  });
  it("are those that a filter leaves, by what came, what was called, and the number", () => {
    expect(told("contact")).toEqual([6]);
    expect(told("ROBOT.state")).toEqual([2, 3, 4, 5, 7, 8]);
    expect(told("8")).toEqual([8]);
    expect(told("nothing like it")).toEqual([]);
  });
  it("never hide a step that called something, or that goes on", () => {
    const calls = [{ service: "robot", operation: "move", args: [], kwargs: {} }] as unknown as TraceStep["calls"];
    const busy = [event(1, "a"), event(2, "b"), { ...event(3, "c"), calls }, event(4, "d"), event(5, "e"), { ...event(6, "f"), complete: false }];
    expect(stepRows(busy, "", undefined, new Set()).every(({ kind }) => kind === "step")).toBe(true);
  });
});
