import { describe, expect, it } from "vitest";
import { stepBy, stepState, untilHere } from "../../shared/debugger/steps";
import { tree } from "./task";

const active = ["Root", "Root/B", "Root/B/C", "Root/A"];

describe("stepState", () => {
  it("is the selected state if that is active, else the innermost", () => {
    expect(stepState(tree, active, { kind: "node", path: "Root/A" })).toBe("Root/A");
    expect(stepState(tree, active, { kind: "node", path: "Root/Old" })).toBe("Root/B/C");
    expect(stepState(tree, active, undefined)).toBe("Root/B/C");
    expect(stepState(tree, [], undefined)).toBeUndefined();
  });
});

describe("stepBy", () => {
  const at = (path: string) => ({ kind: "node", path }) as const;
  it("goes into and over the state, and out of the one around it", () => {
    expect(stepBy(tree, active, at("Root/B"), "into")).toEqual({ request: { kind: "until", id: "b", when: "into" } });
    expect(stepBy(tree, active, at("Root/B"), "over")).toEqual({ request: { kind: "until", id: "b", when: "left" } });
    expect(stepBy(tree, active, undefined, "out")).toEqual({ request: { kind: "until", id: "b", when: "left" } });
  });
  it("goes on to the next state where none is active in the innermost one", () => {
    expect(stepBy(tree, ["Root", "Root/B"], undefined, "over")).toEqual({ request: { kind: "until", id: "b", when: "into" } });
    expect(stepBy(tree, ["Root", "Root/B"], at("Root/B"), "over")).toEqual({ request: { kind: "until", id: "b", when: "left" } });
  });
  it("says why there is none", () => {
    expect(stepBy(tree, [], undefined, "over")).toEqual({ reason: "no state is active" });
    expect(stepBy(tree, ["Root"], undefined, "out")).toEqual({ reason: "nothing is around the root" });
  });
});

describe("untilHere", () => {
  it("is until a state is entered or a port fires", () => {
    expect(untilHere(tree, { kind: "node", path: "Root/Old" })).toEqual({ request: { kind: "until", path: "Root/Old", when: "entered" } });
    expect(untilHere(tree, { kind: "port", address: "Root/A.done" })).toEqual({ request: { kind: "until", id: "a-done", when: "fired" } });
    expect(untilHere(tree, { kind: "port", address: "Root/A.late" })).toEqual({ request: { kind: "until", path: "Root/A.late", when: "fired" } });
    expect(untilHere(tree, { kind: "node", path: "Root/Gone" })).toEqual({ reason: "only states and ports are reached" });
    expect(untilHere(tree, undefined)).toEqual({ reason: "nothing is selected" });
  });
});
