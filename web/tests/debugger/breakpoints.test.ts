import { describe, expect, it } from "vitest";
import type { KeptBreakpoint } from "../../generated/messages";
import { applyBreakpoints, asSent, enabledOf, kMostBreakpoints, newBreakpoint, type BreakpointChange, type Entry } from "../../shared/debugger/breakpoints";

const apply = (changes: readonly BreakpointChange[], from: readonly Entry[] = []) => changes.reduce(applyBreakpoints, from);
const kinds = (entries: readonly Entry[]) => entries.map(({ breakpoint }) => breakpoint.when);
const at = (id: string): BreakpointChange => ({ type: "toggled", when: "entered", where: { id } });

describe("applyBreakpoints", () => {
  it("sets and removes one at a place, and no other kind or place", () => {
    const two = apply([at("a"), { type: "toggled", when: "left", where: { id: "a" } }]);
    expect(two.map(({ breakpoint }) => breakpoint)).toEqual([{ when: "entered", id: "a", enabled: true }, { when: "left", id: "a", enabled: true }]);
    expect(kinds(apply([at("a")], two))).toEqual(["left"]);
    expect(kinds(apply([{ type: "toggled", when: "entered", where: { path: "a" } }], two))).toEqual(["entered", "left", "entered"]);
  });

  it("takes fields away that say nothing, so that the server gets none that are empty", () => {
    const [one] = apply([at("a"), { type: "set", number: 1, fields: { condition: "var.n > 2", before: true } }]);
    expect(one?.breakpoint).toEqual({ when: "entered", id: "a", enabled: true, before: true, condition: "var.n > 2" });
    const [other] = apply([{ type: "set", number: 1, fields: { condition: "", before: false, enabled: false } }], one === undefined ? [] : [one]);
    expect(other?.breakpoint).toEqual({ when: "entered", id: "a", enabled: false });
  });

  it("gives each another number, also after one was removed", () => {
    const entries = apply([at("a"), at("b"), { type: "removed", number: 1 }, at("c")]);
    expect(entries.map(({ number }) => number)).toEqual([2, 3]);
  });

  it("keeps numbers of what is loaded as it was, whatever the order of its fields", () => {
    const before = apply([{ type: "added", breakpoint: { enabled: true, before: true, when: "left", id: "a" } }]);
    expect(apply([{ type: "loaded", breakpoints: [{ when: "left", id: "a", before: true, enabled: true }] }], before)).toBe(before);
    const after = apply([{ type: "loaded", breakpoints: [{ when: "left", id: "a", before: true, enabled: false }] }], before);
    expect(after.map(({ number }) => number)).toEqual([2]);
  });

  it("has no more than the server takes", () => {
    const full = apply(Array.from({ length: kMostBreakpoints }, (_, i) => at(`s${i}`)));
    expect(full.length).toBe(100);
    expect(apply([at("one-more")], full)).toBe(full);
    expect(apply([at("s7")], full).length).toBe(99);
  });
});

describe("a breakpoint for a core", () => {
  it("is one that is enabled, without what only the page keeps", () => {
    const disabled: KeptBreakpoint = { when: "fault", enabled: false };
    const entries = apply([{ type: "added", breakpoint: newBreakpoint("called") }, { type: "added", breakpoint: disabled }]);
    expect(enabledOf(entries)).toEqual([{ when: "called" }]);
    expect(Object.keys(asSent({ when: "tested", id: "p", enabled: true }))).toEqual(["when", "id"]);
  });
  it("has the condition that its kind needs", () => {
    expect(newBreakpoint("fulfilled", { id: "a" })).toEqual({ when: "fulfilled", id: "a", condition: "True", enabled: true });
    expect(newBreakpoint("fault")).toEqual({ when: "fault", before: true, enabled: true });
  });
});
