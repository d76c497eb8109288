import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import { breakpointMarks, breakpointText, markOfClosed, markOfState, placeText, reachedBy, selectionOf, whereOf } from "../../shared/debugger/places";
import { tree } from "./task";

describe("the place of a breakpoint", () => {
  it("is named by id where there is one, else by path", () => {
    expect(whereOf(tree, { kind: "node", path: "Root/A" })).toEqual({ id: "a" });
    expect(whereOf(tree, { kind: "port", address: "Root/A.done" })).toEqual({ id: "a-done" });
    expect(whereOf(tree, { kind: "port", address: "Root/A.late" })).toEqual({ path: "Root/A.late" });
    expect(whereOf(tree, { kind: "node", path: "Root/Old" })).toEqual({ path: "Root/Old" });
  });
  it("is found again, of an action its state", () => {
    expect(selectionOf(tree, { when: "fired", id: "a-done" })).toEqual({ kind: "port", address: "Root/A.done" });
    expect(selectionOf(tree, { when: "executed", id: "act2" })).toEqual({ kind: "node", path: "Root/A" });
    expect(selectionOf(tree, { when: "tested", path: "Root/A.late" })).toEqual({ kind: "port", address: "Root/A.late" });
    expect(selectionOf(tree, { when: "entered", id: "gone" })).toBeUndefined();
    expect(selectionOf(tree, { when: "fault" })).toBeUndefined();
  });
  it("is called by its name", () => {
    expect(placeText(tree, { when: "executed", id: "act2" })).toBe("action 2 of A");
    expect(placeText(tree, { when: "fired", id: "a-done" })).toBe("A.done");
    expect(placeText(tree, { when: "called" })).toBe("the whole task");
    expect(placeText(tree, { when: "entered", id: "gone" })).toBe("what is not here");
    expect(breakpointText(tree, { when: "called", id: "b", service: "robot", operation: "move", before: true })).toBe("B, before: calls robot.move");
    expect(breakpointText(tree, { when: "called", service: "robot" })).toBe("the whole task, calls robot.any operation");
  });
});

describe("breakpointMarks", () => {
  const marks = breakpointMarks(tree, [
    { when: "entered", id: "a", enabled: false }, { when: "tested", id: "a-done", enabled: true }, { when: "executed", id: "act1", enabled: true }, { when: "left", id: "a", enabled: false }, { when: "fault", enabled: true }, { when: "left", id: "c", enabled: false },
  ]);
  it("has one for each state and port, filled if any there is enabled", () => {
    expect([...marks.values()].map(({ address, on }) => [address, on])).toEqual([["Root/A", true], ["Root/A.done", true], ["Root/B/C", false]]);
    expect(marks.get("Root/A")?.text).toBe("Breakpoint: disabled: A, entered; action 1 of A, executed; disabled: A, left");
  });
  it("counts those of its ports for the row of a state, and no other's", () => {
    expect(markOfState(breakpointMarks(tree, [{ when: "fired", id: "a-done", enabled: true }]), "Root/A")?.on).toBe(true);
    expect(markOfState(marks, "Root/B")).toBeUndefined();
  });
  it("counts those within a state that is closed, and tells a few", () => {
    const inside = breakpointMarks(tree, [{ when: "fired", id: "a-done", enabled: false }, { when: "entered", id: "a", enabled: true }]);
    expect(markOfState(inside, "Root")).toBeUndefined();
    expect(markOfState(inside, "Root", true)).toEqual({ address: "Root", on: true, text: "Breakpoint: disabled: A.done, fired; Breakpoint: A, entered" });
    expect(markOfClosed(inside, "Root")?.text).toBe(markOfState(inside, "Root", true)?.text);
    expect(markOfClosed(inside, "Root/A")?.text, "its ports are drawn").toBe("Breakpoint: A, entered");
    const many = new Map(["a", "b", "c", "d", "e"].map((name) => [`Root/${name}`, { address: `Root/${name}`, on: false, text: name }]));
    expect(markOfClosed(many, "Root")).toEqual({ address: "Root", on: false, text: "a; b; c; 2 more" });
  });
});

describe("reachedBy", () => {
  const core: Core = { id: "1", document: "t", revision: 1, status: "running", paused: true, stepping: false, step: 1, micro: 1, waiting: 0, arguments: {}, breakpoints: [{ when: "entered", id: "a" }, { when: "left", id: "b" }], live: false, model: 0 };
  it("gives those at which the core is paused, by their numbers", () => {
    expect(reachedBy({ ...core, reached: [1] })).toEqual([{ when: "left", id: "b" }]);
    expect(reachedBy(core)).toEqual([]);
    expect(reachedBy({ ...core, reached: [0], paused: false })).toEqual([]);
    expect(reachedBy({ ...core, reached: [7] })).toEqual([]);
  });
});
