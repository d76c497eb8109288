import { describe, expect, it } from "vitest";
import type { Run } from "../../generated/messages";
import { applyRunList, countText, kNoRuns, matchingRuns, outcomeOf, type RunListEvent } from "../../shared/runs/list";
import { isRunFile } from "../../shared/runs/runFile";
import { readJson } from "../files";

const example = readJson(new URL("../../../api/examples/run.ended.json", import.meta.url)) as Run;
const run = (id: string, of: Partial<Run> = {}): Run => ({ ...example, id, ...of });
const listed = (...events: readonly RunListEvent[]) => events.reduce(applyRunList, kNoRuns);

describe("the list of runs", () => {
  const both = listed({ type: "newest", part: { runs: [run("12"), run("9")], next: 9 } }, { type: "older", part: { runs: [run("9", { steps: 7 }), run("8")] } });
  it("grows by older ones, each run once, the newest first by number", () => {
    expect(both.runs.map(({ id, steps }) => [id, steps])).toEqual([["12", 2], ["9", 7], ["8", 2]]);
    expect(both.next).toBeUndefined();
    expect(applyRunList(both, { type: "changed", run: run("13") }).runs.map(({ id }) => id)).toEqual(["13", "12", "9", "8"]);
  });
  it("begins anew, and loses what was removed", () => {
    expect(applyRunList(both, { type: "newest", part: { runs: [run("14")] } }).runs.map(({ id }) => id)).toEqual(["14"]);
    expect(applyRunList(both, { type: "removed", id: "9" }).runs.map(({ id }) => id)).toEqual(["12", "8"]);
  });
  it("says how many of them a search has found", () => {
    const first = listed({ type: "newest", part: { runs: [run("12"), run("9")], next: 9 } });
    expect([countText(3, both), countText(1, both), countText(2, first), countText(1, first), countText(1, listed({ type: "newest", part: { runs: [run("1")] } }))]).toEqual(["3 runs", "1 of 3 runs", "The newest 2 runs", "1 of the newest 2 runs", "1 run"]);
  });
});

describe("a search", () => {
  const runs = [run("3", { document: "pick", outcome: "error", arguments: { speed: 0.25 } }), run("2", { status: "faulted", fault: { kind: "unmet", at: "Root", message: "the barrier" } }), run("1", { status: "running" })];
  const found = (text: string, outcome?: ReturnType<typeof outcomeOf>) => matchingRuns(runs, { text, outcome }).map(({ id }) => id);
  it("finds all words, in any case, in what is said of a run", () => {
    expect([found(""), found("Pick ERROR"), found("pick ticking"), found("barrier"), found("speed 0.25"), found("faulted")]).toEqual([["3", "2", "1"], ["3"], [], ["2"], ["3"], ["2"]]);
  });
  it("finds by what a run came to", () => {
    expect([found("", "bad"), found("", "open"), found("", "good"), found("pick", "bad")]).toEqual([["3", "2"], ["1"], [], ["3"]]);
  });
});

describe("what a run came to", () => {
  it.each([
    ["ended", "success", "good"], ["ended", "done", "good"], ["ended", "error", "bad"], ["ended", "Failed", "bad"], ["ended", "noerror", "good"],
    ["faulted", undefined, "bad"], ["aborted", undefined, "bad"], ["running", undefined, "open"], ["interrupted", undefined, "waits"], ["ready", undefined, "ready"],
  ] as const)("is, %s by %s, %s", (status, outcome, expected) => expect(outcomeOf({ status, ...(outcome !== undefined && { outcome }) })).toBe(expected));
});

describe("a file of a run", () => {
  it("is told from a document, and from what is no JSON", () => {
    const file = readJson(new URL("../../../api/examples/run_file.ticking.json", import.meta.url));
    const document = readJson(new URL("../../../api/examples/document.pick.json", import.meta.url));
    expect([isRunFile(JSON.stringify(file)), isRunFile(JSON.stringify(document)), isRunFile("{"), isRunFile("[]"), isRunFile("null")]).toEqual([true, false, false, false, false]);
  });
});
