// The form in which a pose is saved.
import { describe, expect, it } from "vitest";
import { applySaving, kFirstSaving, shownSaving, type SavingEvent } from "../../shared/pendant/saving";

const after = (...events: readonly SavingEvent[]) => events.reduce(applySaving, kFirstSaving);
const kTaken = { type: "taken" } as const;
const named = (names: readonly string[], ...events: readonly SavingEvent[]) => shownSaving(after(...events), { names, isNamed: true });

describe("the name of a pose that is saved", () => {
  it("is one that is free, until a person writes another one", () => {
    expect(named(["pose1"])).toMatchObject({ name: "pose2", button: "save", hint: undefined });
    expect(named(["pose1"], { type: "written", entry: "a" })).toMatchObject({ name: "a", isTaken: false });
    expect(shownSaving(kFirstSaving, { names: [], stem: "part", isNamed: false })).toMatchObject({ name: "part1", button: "proposed" });
  });

  it("that is taken is said so again when it is written again, whatever was said of the last save", () => {
    const writing = { type: "written", entry: "a" } as const;
    expect(named(["a"], writing)).toMatchObject({ button: "replace", hint: kTaken });
    expect(named(["a"], writing, { type: "saved", name: "a" })).toMatchObject({ hint: { type: "saved", name: "a" } });
    expect(named(["a"], writing, { type: "saved", name: "a" }, writing)).toMatchObject({ hint: kTaken, isBad: false });
    expect(named(["a"], writing, { type: "not_saved", why: "a is there already" })).toMatchObject({ hint: { type: "not_saved", why: "a is there already" }, isBad: true });
    expect(named(["a"], writing, { type: "not_saved", why: "a is there already" }, writing)).toMatchObject({ hint: kTaken, isBad: false });
  });

  it("that is none says why", () => {
    expect(named([], { type: "written", entry: "a b" })).toMatchObject({ isName: false, isBad: true, hint: { type: "no_name" } });
  });

  it("that is fixed is the one the button saves, with what becomes of the pose that has it", () => {
    const fixed = { names: ["above"], fixed: "above", isNamed: false };
    expect(shownSaving(kFirstSaving, fixed)).toMatchObject({ name: "above", button: "fixed", hint: kTaken });
    expect(shownSaving(after({ type: "saved", name: "above" }), fixed)).toMatchObject({ name: "above", hint: { type: "saved", name: "above" } });
  });
});
