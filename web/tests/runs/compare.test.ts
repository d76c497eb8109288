import { describe, expect, it } from "vitest";
import type { RunComparison } from "../../generated/messages";
import { compareAll, comparisonText, firstDifference } from "../../shared/runs/compare";
import { readJson } from "../files";

const differs = readJson(new URL("../../../api/examples/run_comparison.different.json", import.meta.url)) as RunComparison;
const runs = ["7", "9"] as const;
const text = (of: RunComparison) => comparisonText(of, [...runs]);

describe("two runs", () => {
  it("are compared part by part, until they differ", async () => {
    const asked: number[] = [];
    const found = await compareAll(async (from) => {
      asked.push(from);
      return Promise.resolve(from < 4001 ? { same: true, steps: [6000, 6000], compared: from + 1999, next: from + 2000 } : differs);
    });
    expect([asked, found]).toEqual([[1, 2001, 4001], differs]);
  });
  it("are not compared for ever", async () => {
    let asked = 0;
    const found = await compareAll((from) => Promise.resolve({ same: true, steps: [++asked, 9], compared: from, next: from + 1 }));
    expect(asked).toBe(50);
    expect(text(found)).toBe("The same up to macro step 50; further ones were not compared.");
  });
  it("differ first at a moment that can be looked at", () => {
    expect(firstDifference({ ...differs, step: 12, micro: 3 })).toEqual({ step: 12, micro: 3 });
    expect(firstDifference({ same: true, steps: [2, 2], compared: 2 })).toBeUndefined();
  });
  it("are said to be the same, or to differ in a derivation, in a result, or in their length", () => {
    const step = differs.first ?? null;
    expect(text({ same: false, steps: [20, 20], compared: 11, step: 12, micro: 3, first: step, second: step })).toBe("They first differ in macro step 12, micro step 4.");
    expect(text({ same: false, steps: [20, 20], compared: 11, step: 12, first: step, second: step })).toContain("its derivations are the same");
    expect(text({ same: false, steps: [11, 20], compared: 11, step: 12, first: null, second: step })).toBe("The same up to macro step 11, where run 7 ends; run 9 goes on.");
    expect(text({ same: true, steps: [20, 20], compared: 20 })).toBe("The same: derivations, calls and states of all 20 macro steps.");
  });
});
