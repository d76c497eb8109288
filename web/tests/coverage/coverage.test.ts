import { describe, expect, it } from "vitest";
import type { ModelCoverage } from "../../generated/messages";
import { coverageOf, placesOf } from "../../shared/coverage/coverage";
import { drawnCoverage } from "../../shared/coverage/drawnCoverage";
import { countText, otherText, partlyText, reportText } from "../../shared/coverage/texts";
import type { DrawnNode } from "../../shared/drawing/drawing";
import { editedState } from "../../shared/edit/editedModel";
import { buildTree } from "../../shared/model/modelTree";
import { treeOf } from "../edit/documents";

const meta = (id: string) => ({ meta: { id } });
const document = treeOf({
  rcm: 1,
  library: [{ state: "Open", ports: [{ name: "open", when: "x", ...meta("open-p") }], ...meta("open") }],
  root: {
    state: "Root", ...meta("root"),
    children: [
      { state: "A", ...meta("a"), actions: [{ when: "True", do: "", ...meta("a-act") }], ports: [{ name: "done", when: "x", ...meta("a-done") }, { name: "lost", when: "x", ...meta("a-lost") }] },
      { state: "B", ...meta("b"), children: [{ state: "C", ports: [{ name: "done", when: "x", ...meta("c-done") }], ...meta("c") }] },
      { barrier: "Both", to: [], ...meta("both") },
    ],
  },
});

const places = (reached: readonly string[], missing: readonly string[]) => ({ covered: reached.length, all: reached.length + missing.length, reached, missing });
const model: ModelCoverage = {
  states: places(["Root", "Root/A", "Root/B", "library/Open"], ["Root/B/C"]),
  ports: places(["Root/A.done", "library/Open.open"], ["Root/A.lost", "Root/B/C.done"]),
  conditions: {
    covered: 2, all: 6,
    reached: [{ at: "Root/A.done", value: true }, { at: "Root/A", action: 1, value: true }],
    missing: [{ at: "Root/A.done", value: false }, { at: "Root/A", action: 1, value: false }, { at: "Root/B/C.done", value: true }, { at: "Root/B/C.done", value: false }],
  },
};

describe("coverage of a document", () => {
  const coverage = coverageOf(document, model);
  it("finds its places by path, as the server writes them", () => {
    expect(Object.fromEntries(placesOf(document))).toEqual({
      Root: "root", "Root/A": "a", "Root/A.done": "a-done", "Root/A.lost": "a-lost", "Root/B": "b", "Root/B/C": "c", "Root/B/C.done": "c-done", "library/Open": "open", "library/Open.open": "open-p",
    });
  });
  it("counts and lists what is missing, with the element to go to", () => {
    expect(coverage.counts).toEqual({ states: { covered: 4, all: 5 }, ports: { covered: 2, all: 4 }, conditions: { covered: 2, all: 6 } });
    expect(coverage.gaps.map(({ kind, text, id }) => `${kind} ${text} ${id ?? "?"}`)).toEqual([
      "states Root/B/C c", "ports Root/A.lost a-lost", "ports Root/B/C.done c-done",
      "conditions Root/A.done never false a-done", "conditions Root/A action 1 never false a", "conditions Root/B/C.done never true c-done", "conditions Root/B/C.done never false c-done",
    ]);
  });
  it("marks what was never active or fired, and what was of which conditions are missing", () => {
    expect([...coverage.marks].map(([id, { kind, text }]) => `${id} ${kind}: ${text}`)).toEqual([
      "c never: Never active in the tests", "a-lost never: Never fired in the tests", "c-done never: Never fired in the tests",
      "a partly: 2 of 4 values of conditions seen: done never false, action 1 never false",
    ]);
  });
  it("says of a state of the library that it was not tested by itself, as links to it are active in its place", () => {
    const { marks } = coverageOf(document, { ...model, states: places([], ["library/Open"]) });
    expect(marks.get("open")).toEqual({ kind: "never", text: "No test runs it by itself" });
  });
  it("fits the document of the same states and ports", () => {
    expect([coverage.unknown, coverage.untold]).toEqual([[], []]);
  });
  it("of another revision is told by what only one of both has", () => {
    const other = coverageOf(document, { ...model, states: places(["Root", "Root/A", "Root/Gone", "library/Open"], []) });
    expect([other.unknown, other.untold]).toEqual([["Root/Gone"], ["Root/B", "Root/B/C"]]);
    expect(other.gaps.every(({ id }) => id !== undefined)).toBe(true);
  });
  it("says nothing of a state of the library that no test can run by itself", () => {
    const { untold } = coverageOf(document, { ...model, states: places(["Root", "Root/A", "Root/B"], ["Root/B/C"]), ports: places(["Root/A.done"], ["Root/A.lost", "Root/B/C.done"]) });
    expect(untold).toEqual([]);
  });
  it("names a gap that the document does not have, without a way to it", () => {
    expect(coverageOf(document, { ...model, ports: places([], ["Root/X.done"]) }).gaps.find(({ kind }) => kind === "ports")).toEqual({ kind: "ports", text: "Root/X.done", id: undefined });
  });
});

const node = (path: string, more: Partial<DrawnNode> = {}): DrawnNode => ({
  kind: "state", path, name: path, depth: 0, composite: false, open: false, lines: [], ports: [], side: "EAST", x: 1, y: 2, width: 3, height: 4, ...more,
});
const port = (address: string) => ({ address, name: "", condition: "", when: "", timed: false, exits: false, x: 5, y: 6, width: 7, height: 8 });

describe("the signs of coverage", () => {
  const { marks } = coverageOf(document, model);
  const tree = buildTree(editedState(document, document.root));
  const drawn = (...nodes: readonly DrawnNode[]) => drawnCoverage(marks, { tree, drawing: { nodes, lines: [], width: 0, height: 0 } }).map(({ address, of, kind, text, box: { x } }) => `${of} ${address} ${kind} at ${x}: ${text}`);
  it("are at states and ports", () => {
    expect(drawn(node("Root/A", { ports: [port("Root/A.done"), port("Root/A.lost")] }), node("Root/B/C"), node("Root/Both", { kind: "barrier" }))).toEqual([
      "state Root/A partly at 1: 2 of 4 values of conditions seen: done never false, action 1 never false", "port Root/A.lost never at 5: Never fired in the tests",
      "state Root/B/C never at 1: Never active in the tests",
    ]);
  });
  it("tell of a closed state what is missing in it, and of an open one nothing", () => {
    expect(drawn(node("Root/B", { composite: true }))).toEqual(["state Root/B partly at 1: 2 states and ports in it never active or fired"]);
    expect(drawn(node("Root/B", { composite: true, open: true }))).toEqual([]);
  });
});

describe("coverage in words", () => {
  it("has shares rounded down, so that 100 % is all", () => {
    expect([countText({ covered: 199, all: 200 }), countText({ covered: 0, all: 0 })]).toEqual(["199 of 200 (99 %)", "0 of 0 (100 %)"]);
  });
  it("names three conditions", () => {
    expect(partlyText({ covered: 1, all: 5 }, ["a", "b", "c", "d"])).toBe("1 of 5 values of conditions seen: a, b, c, 1 more");
  });
  it("says how many tests have failed", () => {
    const test = (passed: boolean) => ({ file: "a", name: "a", seed: 1, time: 0, passed, findings: [] });
    expect([[true], [true, false]].map((all) => reportText({ file: "c.json", tests: all.map(test), models: {} }))).toEqual(["c.json: 1 test, all passed", "c.json: 2 tests, 1 failed"]);
  });
  it("says of which document or revision it is, if it is another", () => {
    expect(otherText("a/pick.rcm.json", "pick", "pick", [], [])).toBeUndefined();
    expect(otherText("a/pick.rcm.json", "pick", "place", [], [])).toBe("It is of a/pick.rcm.json, not of place.");
    expect(otherText("a/pick.rcm.json", "pick", "pick", ["Root/X"], ["Root/Y", "Root/Z"])).toBe(
      "It is of another revision: it has 1 state or port that the document does not have (Root/X), and it says nothing of 2 states and ports of the document (Root/Y). Run the tests again.",
    );
  });
});
