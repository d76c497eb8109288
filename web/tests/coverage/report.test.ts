import { describe, expect, it } from "vitest";
import { documentOfModel, isTestReport, modelFor, readReport } from "../../shared/coverage/report";
import { readJson } from "../files";

const example = readJson(new URL("../../../api/examples/test_report.baking.json", import.meta.url)) as { readonly tests: readonly object[]; readonly coverage: Record<string, object> };
const read = (json: unknown) => readReport("coverage.json", JSON.stringify(json));

describe("a file of coverage", () => {
  it("is read with its tests and models", () => {
    const report = read(example);
    expect([report.file, report.tests.length, Object.keys(report.models)]).toEqual(["coverage.json", 2, ["baking.rcm.json"]]);
  });
  it("is told from documents and from tests by what is in it", () => {
    expect(isTestReport(JSON.stringify(example))).toBe(true);
    for (const other of [{ rcm: 1, root: {} }, { race_test: 1, tests: [] }, { tests: 1 }, [], null]) expect(isTestReport(JSON.stringify(other))).toBe(false);
    expect(isTestReport("{")).toBe(false);
  });
  it.each([
    ["what is no JSON", "{", /no coverage: .*JSON/],
    ["a document", JSON.stringify({ rcm: 1, root: {} }), /\/tests: expected a value, got undefined/],
    ["a wrong place", JSON.stringify({ tests: [], coverage: { "a.rcm.json": { ...example.coverage["baking.rcm.json"], ports: 1 } } }), /ports: expected object, got number/],
    ["one without coverage", JSON.stringify({ tests: [] }), /made without --coverage/],
    ["one without a model", JSON.stringify({ tests: [], coverage: {} }), /has no model/],
  ])("refuses %s, with its name, the reason, and what makes one", (_, text, reason) => {
    expect(() => readReport("coverage.json", text)).toThrow(reason);
    expect(() => readReport("coverage.json", text)).toThrow(/^coverage\.json is no coverage: .*`race test --coverage --json FILE > coverage\.json`/s);
  });
  it("has the model of a document by the name of its file, else its first one", () => {
    expect(["deploy/demo/pick.rcm.json", "pick.json", "pick"].map(documentOfModel)).toEqual(["pick", "pick", "pick"]);
    const model = example.coverage["baking.rcm.json"];
    const report = read({ ...example, coverage: { "a/pick.rcm.json": model, "a/place.rcm.json": model } });
    expect([modelFor(report, "place"), modelFor(report, "other"), modelFor(report, undefined)]).toEqual(["a/place.rcm.json", "a/pick.rcm.json", "a/pick.rcm.json"]);
  });
});
