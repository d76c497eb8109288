import { describe, expect, it } from "vitest";
import type { Breakpoint } from "../../generated/messages";
import { missingOn, refusedOne, sameBreakpoints, withChanged } from "../../shared/debugger/onCore";

const entered = (id: string): Breakpoint => ({ when: "entered", id });
const [a, b, c] = [entered("a"), entered("b"), entered("c")];

describe("withChanged", () => {
  it("removes and adds what a person has changed, and keeps what others have set", () => {
    expect(withChanged([b, a], [a], [c])).toEqual([b, c]);
    expect(withChanged([b, a], [a], [])).toEqual([b]);
  });
  it("leaves the one of somebody else where two have set the same", () => {
    expect(withChanged([a], [], [a])).toEqual([a, a]);
    expect(withChanged([a, a], [a], [])).toEqual([a]);
  });
  it("takes breakpoints for the same that mean the same", () => {
    expect(withChanged([{ when: "entered", id: "a" }], [{ id: "a", when: "entered", before: false, condition: "" }], [])).toEqual([]);
    expect(withChanged([{ when: "entered", id: "a", before: true }], [a], [])).toEqual([{ when: "entered", id: "a", before: true }]);
  });
  it("removes none that the core has lost by an edit, and not another one for it", () => expect(withChanged([b], [a], [])).toEqual([b]));
});

describe("missingOn", () => {
  it("says what a core does not have yet", () => {
    expect(missingOn([b, a], [a, c])).toEqual([c]);
    expect(missingOn([], [a])).toEqual([a]);
    expect(missingOn([a], [a, a])).toEqual([a]);
  });
});

describe("sameBreakpoints", () => {
  it("compares in order", () => {
    expect(sameBreakpoints([a, b], [a, b])).toBe(true);
    expect(sameBreakpoints([a, b], [b, a])).toBe(false);
    expect(sameBreakpoints([a], [a, b])).toBe(false);
  });
});

describe("refusedOne", () => {
  const error = (path: string) => ({ code: "syntax", message: "expected an expression", path });
  it("finds which one the server does not take", () => {
    expect(refusedOne([error("breakpoints/3/condition")])).toEqual({ index: 3, message: "condition: expected an expression" });
    expect(refusedOne([error("breakpoints/12/id")])).toEqual({ index: 12, message: "expected an expression" });
  });
  it("finds none where the request as a whole is refused", () => expect(refusedOne([error("breakpoints"), error("7")])).toBeUndefined());
});
