import { describe, expect, it } from "vitest";
import type { Core, Input, Journal } from "../../generated/messages";
import { allForced, forcedInJournal, withForced } from "../../shared/run/forced";

const core = (step: number) => ({ step }) as Core;
const force = (name: string): Input => ({ kind: "force", force: { path: "Root", scope: "var", name, value: 3 } });
const start: Input = { kind: "start" };

describe("what was forced", () => {
  it("is taken from deltas, once of a macro step that comes in parts", () => {
    const known = withForced([], { core: core(2), input: force("n") });
    expect(known).toEqual([{ step: 2, input: force("n") }]);
    expect(withForced(known, { core: core(2), input: force("n") })).toBe(known);
    expect(withForced(known, { core: core(3), input: start })).toBe(known);
    expect(withForced(known, { core: core(4), input: force("m") }).map(({ step }) => step)).toEqual([2, 4]);
  });
  it("is taken from the journal for what was before, and each step is there once", () => {
    const journal = { entries: [{ position: 1, input: start }, { position: 2, input: force("n") }, { position: 5, input: force("m") }] } as Partial<Journal> as Journal;
    const past = forcedInJournal(journal);
    expect(past.map(({ step }) => step)).toEqual([2, 5]);
    expect(allForced(past, [{ step: 5, input: force("m") }, { step: 7, input: force("k") }]).map(({ step }) => step)).toEqual([2, 5, 7]);
  });
});
