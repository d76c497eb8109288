import { describe, expect, it } from "vitest";
import type { Breakpoint } from "../../generated/messages";
import { missingOn, refusedOne, sameBreakpoints, setBy } from "../../shared/debugger/onCore";

const entered = (id: string): Breakpoint => ({ when: "entered", id });
const [a, b, c] = [entered("a"), entered("b"), entered("c")];

const core = { breakpoints: [b, { ...a, author: "Ann" }, { ...c, author: "Bo" }, { ...c, author: "Ann" }] };

describe("the breakpoints of a core", () => {
  it("are those of each who has set some, and of nobody", () => {
    expect(setBy(core, "Ann").map(({ id }) => id)).toEqual(["a", "c"]);
    expect(setBy(core, "Cem")).toEqual([]);
  });
  it("are missed where the person has not set them, whatever others have", () => {
    expect(missingOn(core, "Ann", [a, b])).toEqual([b]);
    expect(missingOn(core, "Bo", [c, a])).toEqual([a]);
    expect(missingOn(core, "Ann", [{ ...a, before: true }])).toEqual([{ ...a, before: true }]);
  });
  it("are the same where they mean the same", () => expect(missingOn(core, "Ann", [{ id: "a", when: "entered", before: false, condition: "" }])).toEqual([]));
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
