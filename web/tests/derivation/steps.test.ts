import { describe, expect, it } from "vitest";
import type { Call, Derivation, TraceStep } from "../../generated/messages";
import { mergeSteps, microCount } from "../../shared/derivation/steps";

/** Micro step `n`. */
const micro = (n: number): Derivation => ({ rule: "Micro", equation: "3.31", at: `Root/S${n}`, premises: [] });
const call = (n: number): Call => ({ service: "robot", operation: "move", args: [n], kwargs: {}, call: n });
const range = (first: number, end: number): readonly number[] => Array.from({ length: end - first }, (_, i) => first + i);

/** Micro steps `first` up to before `end` of a macro step; each calls. */
const part = (first: number, end: number, complete: boolean, step = 1): TraceStep => ({
  step, input: { kind: "start" }, micro: range(first, end).map(micro), calls: range(first, end).map(call), first, complete,
});
const merge = (...parts: readonly TraceStep[]): readonly TraceStep[] => parts.reduce<readonly TraceStep[]>((known, added) => mergeSteps(known, [added]), []);

describe("mergeSteps", () => {
  it("joins the parts of a macro step", () => {
    expect(merge(part(0, 256, false), part(256, 512, false), part(512, 520, true))).toEqual([part(0, 520, true)]);
  });
  it("completes a macro step by a last part without micro steps", () => {
    expect(merge(part(0, 256, false), part(256, 256, true))).toEqual([part(0, 256, true)]);
  });
  it("takes a part that comes again only once, with its calls", () => {
    expect(merge(part(0, 2, false), part(2, 4, true), part(2, 4, true))).toEqual([part(0, 4, true)]);
    expect(merge(part(0, 2, false), part(2, 4, true), part(0, 2, false))).toEqual([part(0, 4, true)]);
    expect(merge(part(0, 4, true), part(2, 4, false))).toEqual([part(0, 4, true)]);
  });
  it("loses nothing of a macro step that was loaded before the rest of it came, or meanwhile", () => {
    const loaded = part(0, 5, false);
    expect(merge(loaded, part(2, 4, false), part(4, 6, false), part(6, 7, true))).toEqual([part(0, 7, true)]);
    expect(merge(loaded, merge(part(2, 4, false), part(4, 6, true))[0] ?? loaded)).toEqual([part(0, 6, true)]);
  });
  it("keeps the numbers of micro steps where the first ones are missing", () => {
    expect(merge(part(2, 4, false), part(4, 6, true))).toEqual([part(2, 6, true)]);
    expect(merge(part(0, 1, false), part(2, 4, false))).toEqual([part(2, 4, false)]);
    expect(merge(part(2, 4, false), part(0, 1, false))).toEqual([part(2, 4, false)]);
  });
  it("replaces a macro step that comes again whole", () => {
    const again = { ...part(0, 1, true), micro: [micro(7)] };
    expect(merge(part(0, 3, true), again)).toEqual([again]);
  });
  it("orders steps and drops the oldest", () => {
    const merged = mergeSteps([], Array.from({ length: 230 }, (_, i) => part(0, 0, true, 230 - i)));
    expect([merged.length, merged[0]?.step, merged.at(-1)?.step]).toEqual([200, 31, 230]);
  });
});

describe("microCount", () => {
  it("counts the micro steps that are missing, too", () => {
    const { first, ...whole } = part(0, 3, true);
    expect([microCount(whole), microCount(part(first ?? 0, 3, true)), microCount(part(2, 3, true))]).toEqual([3, 3, 3]);
  });
});
