// What a proposal would change, as a drawing: what is drawn open, and the signs in it.
import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { layoutModel } from "../../shared/drawing/layout";
import { svgText } from "../../shared/drawing/svg";
import type { Tree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import { figuresOf, figureSvg, type Figure } from "../../shared/proposals/figure";
import { outlineOf, type Outline } from "../../shared/proposals/outline";
import type { DrawnModel } from "../../shared/versions/ghosts";
import { treeOf } from "../edit/documents";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;

const node = (name: string, more: object = {}) => ({ state: name, meta: { id: name }, ...more });
const holding = (name: string, ...children: readonly object[]) => node(name, { children });
const documentOf = (library: readonly object[], ...children: readonly object[]): Tree => treeOf({ rcm: 1, library, root: holding("Root", ...children) } as unknown as JsonValue);
const kBefore = documentOf([], holding("A", node("A1")), holding("B", node("B1"), holding("B2", node("X"))));
const change = (library: readonly object[], ...children: readonly object[]): Outline => outlineOf(kBefore, documentOf(library, ...children));
const closed = (outline: Outline) => [...(figuresOf(outline)?.now.collapsed ?? ["nothing is drawn"])];

async function drawn({ tree, state, collapsed, places }: Figure): Promise<DrawnModel> {
  return { tree, drawing: await layoutModel(engine, { state, path: state.name, collapsed, places, detail: "ports", aspect: 2 }) };
}
async function drawingOf(outline: Outline): Promise<string> {
  const figures = figuresOf(outline);
  if (figures === undefined) return "";
  return svgText(figureSvg(outline, { now: await drawn(figures.now), was: figures.was && (await drawn(figures.was)) }, { prefix: "p", title: "t" }));
}
const signs = (svg: string) => [...svg.matchAll(/class="svg-mark is-(\w+)"><title>([^<]*)</g)].map(([, kind, text]) => `${kind ?? ""}: ${text ?? ""}`);

describe("the drawing of what would change", () => {
  it("is open around that, and closed elsewhere", () => {
    expect(closed(change([], holding("A", node("A1")), holding("B", node("B1"), holding("B2", node("X", { doc: "new" })))))).toEqual(["Root/A"]);
    expect(closed(change([], holding("A", node("A1")), holding("B", node("B1"), node("B2", { doc: "new", children: [node("X")] }))))).toEqual(["Root/A", "Root/B/B2"]);
  });
  it("is open where something would be removed", () => {
    const outline = change([], holding("A", node("A1")), holding("B", node("B1"), node("B2")));
    expect(closed(outline)).toEqual(["Root/A"]);
    expect([...(figuresOf(outline)?.was?.collapsed ?? [])]).toEqual(["Root/A"]);
  });
  it("is of a new document as a whole", () => {
    expect(closed(outlineOf(undefined, kBefore))).toEqual([]);
  });
  it("is none of what is not drawn, and of what is too large", () => {
    expect(figuresOf(change([node("L")], holding("A", node("A1")), holding("B", node("B1"), holding("B2", node("X")))))).toBeUndefined();
    const many = (count: number) => Array.from({ length: count }, (_, i) => node(`N${i}`));
    expect(closed(outlineOf(undefined, documentOf([], holding("A", ...many(149)))))).toEqual(["Root/A"]);
    expect(closed(outlineOf(undefined, documentOf([], holding("A", ...many(148)))))).toEqual([]);
    expect(figuresOf(outlineOf(undefined, documentOf([], ...many(150))))).toBeUndefined();
  });
  it("has signs, and dashed what would be removed", async () => {
    const svg = await drawingOf(change([], holding("A", node("A1", { doc: "new" })), holding("B", node("B1"), node("C"))));
    expect(signs(svg).sort()).toEqual(["added: added: state Root/B/C", "changed: changed: state Root/A/A1: doc: 'new'", "removed: removed: state Root/B/B2"].sort());
    expect(svg).toMatch(/class="svg-ghost"><title>Removed: state B2</);
  });
  it("has room for what would be removed", async () => {
    const many = Array.from({ length: 12 }, (_, i) => node(`N${i}`));
    const outline = outlineOf(documentOf([], ...many), documentOf([], node("N0")));
    const svg = await drawingOf(outline);
    const [, width = "0", height = "0"] = /viewBox="-12 -12 ([\d.]+) ([\d.]+)"/.exec(svg) ?? [];
    const ghosts = [...svg.matchAll(/class="svg-ghost"><title>[^<]*<\/title><rect x="([\d.]+)" y="([\d.]+)" width="([\d.]+)" height="([\d.]+)"/g)].map((found) => found.slice(1).map(Number));
    expect(ghosts).toHaveLength(11);
    for (const [x = NaN, y = NaN, w = NaN, h = NaN] of ghosts) expect([x + w <= Number(width), y + h <= Number(height)]).toEqual([true, true]);
  });
  it("of a new document has no signs", async () => {
    expect(await drawingOf(outlineOf(undefined, kBefore))).not.toContain("svg-mark");
  });
});
