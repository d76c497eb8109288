// The help: it explains all that there is, and nothing that is not; its figures are whole models; the tour knows what is done.
import { readdirSync, readFileSync } from "node:fs";
import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import { apply, type Operation } from "../../shared/edit/apply";
import { Refusal } from "../../shared/edit/refusal";
import { readTree, type Tree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { layoutModel } from "../../shared/drawing/layout";
import { stubs } from "../../shared/drawing/stubs";
import { drawingSvg, svgText } from "../../shared/drawing/svg";
import { kBuiltins, kModules } from "../../shared/code/words";
import { errorCodes, faultKinds, placeOfCode, requestCodes } from "../../shared/help/errorCodes";
import { exampleState } from "../../shared/help/exampleState";
import { barrier, examples } from "../../shared/help/examples";
import { cellLegend, drawingLegend } from "../../shared/help/legend";
import { findTopics, groupedTopics, topicOf, topics } from "../../shared/help/topics";
import { stepsDone, tourSteps } from "../../shared/help/tour";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;
const project = new URL("../../../", import.meta.url);
const source = (path: string) => readFileSync(new URL(path, project), "utf8");

describe("the help on errors", () => {
  it("has every code of the server, and no other", () => {
    const list = /enum class ErrorCode \{([^}]*)\}/.exec(source("core/value/expected.h"))?.[1] ?? "";
    const codes = [...list.replaceAll(/\/\/.*$/gm, "").matchAll(/\w+/g)].map(([code]) => code);
    expect(codes.length).toBeGreaterThan(30);
    expect(Object.keys(errorCodes).sort()).toEqual([...codes].sort());
  });
  it("has every code of requests, and no other", () => {
    const files = readdirSync(new URL("server/", project), { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".cpp"));
    const codes = new Set(files.flatMap((name) => [...source(`server/${name}`).matchAll(/refusal\(\d+,\s*"(\w+)"/g)].map(([, code]) => code ?? "")));
    expect([...codes].filter((code) => !Object.hasOwn(errorCodes, code)).sort()).toEqual(Object.keys(requestCodes).sort());
  });
  it("has every kind of fault, and no other", () => {
    const { $defs } = JSON.parse(source("api/schemas/core.json")) as { readonly $defs: { readonly fault: { readonly properties: { readonly kind: { readonly enum: readonly string[] } } } } };
    expect(Object.keys(faultKinds).sort()).toEqual([...$defs.fault.properties.kind.enum].sort());
  });
  it("has a place for a code that is known", () => {
    expect([placeOfCode("scope"), placeOfCode("nonsense")]).toEqual([{ topic: "errors", term: "error-scope" }, undefined]);
    const marked = topicOf("errors")?.blocks.flatMap((block) => (block.kind === "terms" ? block.terms.map(({ id }) => id) : []));
    expect(marked).toContain("error-scope");
  });
});

describe("topics of the help", () => {
  it("have ids of their own, and all stand in a group", () => {
    expect(new Set(topics.map(({ id }) => id)).size).toBe(topics.length);
    expect(groupedTopics(topics).flatMap((group) => group.topics)).toHaveLength(topics.length);
  });
  it("have every function of the language", () => {
    const names = topics.flatMap(({ blocks }) => blocks.flatMap((block) => (block.kind === "terms" ? block.terms.map(({ name }) => name) : [])));
    const functions = [...kBuiltins.map(({ name }) => `${name}(`), ...Object.entries(kModules).flatMap(([module, { functions: all }]) => all.map(({ name }) => `${module}.${name}(`))];
    expect(functions.filter((name) => !names.some((each) => each.startsWith(name)))).toEqual([]);
  });
  it("are found by all words, titles first", () => {
    expect(findTopics("RACE_TOKEN program")[0]?.id).toBe("login");
    expect(findTopics("barrier")[0]?.id).toBe("barriers");
    expect(findTopics("atan2 angle").map(({ id }) => id)).toEqual(["language-math"]);
    expect(findTopics("  ")).toBe(topics);
    expect(findTopics("no such words")).toEqual([]);
  });
});

describe("figures of the help", () => {
  it("show what the documents have", () => {
    expect(examples.map((example) => exampleState(example).children.length)).toEqual([0, 2, 6, 3, 1, 2, 2]);
  });
  it("are drawn with an element for every node, port and line", async () => {
    const state = exampleState(barrier);
    const drawing = await layoutModel(engine, { state, path: state.name, collapsed: new Set(), detail: "full", aspect: 2 });
    const text = svgText(drawingSvg(drawing, { prefix: "p", title: 'a < b & "c"' }));
    const count = (pattern: RegExp) => [...text.matchAll(pattern)].length;
    expect([count(/class="svg-state/g), count(/class="svg-barrier/g), count(/class="svg-port/g)]).toEqual([5, 2, 5]);
    expect(count(/class="svg-line/g)).toBe(drawing.lines.length + stubs(drawing).length);
    expect(text).toContain("<title>a &lt; b &amp; &quot;c&quot;</title>");
    for (const name of ["Split", "Watch", "Work", "End", "both are done"]) expect(text).toContain(name);
  });
});

describe("the tour", () => {
  const begin = readTree({ rcm: 1, root: { state: "First", meta: { id: "root" } } }) as Tree;
  const edited = (tree: Tree, ...operations: readonly Operation[]): Tree => {
    const result = apply(tree, { operations });
    if (result instanceof Refusal) throw new Error(result.message);
    return result.tree;
  };
  const insert = (parent: string, list: "children" | "ports", node: JsonValue): Operation => ({ op: "insert", parent, list, node }) as Operation;
  const withState = edited(begin, insert("root", "children", { state: "A", meta: { id: "a" } }));
  const speaking = edited(withState, { op: "set", id: "a", field: "entry", value: 'print("hello")' } as Operation);
  const leaving = edited(speaking, insert("a", "ports", { name: "done", when: "True", meta: { id: "p" } }));
  const ending = edited(leaving, insert("root", "ports", { name: "done", when: "chi.A.port.done", meta: { id: "q" } }));
  const done = (tree: Tree | undefined, errors = 0, run?: "ready" | "ended") => stepsDone({ tree, errors, run: run && { status: run } });

  it("goes on by what is in the document, and by its run", () => {
    expect([undefined, begin, withState, speaking, leaving, ending].map((tree) => done(tree))).toEqual([0, 0, 1, 2, 3, 4]);
    expect([done(ending, 0, "ready"), done(ending, 0, "ended")]).toEqual([5, tourSteps.length]);
  });
  it("does not go on over an error, and comes back when something is taken back", () => {
    expect(done(ending, 1)).toBe(3);
    expect(done(speaking, 0, "ended")).toBe(2);
  });
});

describe("the legend", () => {
  it("has each sign once, and is found in the help", () => {
    const signs = [...drawingLegend, ...cellLegend].flatMap(({ entries }) => entries.map(({ sign }) => sign));
    expect(new Set(signs).size).toBe(signs.length);
    expect(findTopics("deep history").map(({ id }) => id)).toContain("signs");
  });
});
