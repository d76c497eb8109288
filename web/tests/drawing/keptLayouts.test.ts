// What was laid out once is not laid out again; a store that fails, or has something else, does no harm.
import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { keeping, keyOfText, type KeptLayout, type LayoutStore } from "../../shared/drawing/keptLayouts";
import { layoutModel } from "../../shared/drawing/layout";
import { caseNames, modelOf } from "../conformance";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;

function counted(): { readonly engine: LayoutEngine; readonly count: () => number } {
  let count = 0;
  const asked: LayoutEngine = (graph) => {
    count++;
    return engine(graph);
  };
  return { engine: asked, count: () => count };
}

function table(): LayoutStore & { readonly all: Map<string, KeptLayout> } {
  const all = new Map<string, KeptLayout>();
  return {
    all,
    get: (key) => Promise.resolve(all.get(key)),
    set: (key, kept) => Promise.resolve(void all.set(key, kept)),
  };
}

const draw = (name: string, engine: LayoutEngine) => {
  const { root } = modelOf(name);
  return layoutModel(engine, { state: root, path: root.name, collapsed: new Set(), detail: "full", aspect: 1.6 });
};

describe("kept layouts", () => {
  it.each(caseNames.filter((name) => name.startsWith("thesis-")))("give the drawing of %s as the engine gave it, without the engine", async (name) => {
    const store = table();
    const { engine, count } = counted();
    const drawn = await draw(name, keeping(engine, store));
    const asked = count();
    expect(await draw(name, keeping(engine, store))).toEqual(drawn);
    expect(count()).toBe(asked);
  });

  const graph = { id: "all", layoutOptions: { "elk.algorithm": "layered" }, children: [{ id: "a", width: 10, height: 20 }] };

  it("are not those of another graph whose key is the same", async () => {
    const store = table();
    const { engine, count } = counted();
    await keeping(engine, store)(graph);
    const [key = "", kept] = [...store.all][0] ?? [];
    if (kept === undefined) throw new Error("nothing is kept");
    store.all.set(key, { ...kept, graph: `${kept.graph} ` });
    await keeping(engine, store)(graph);
    expect(count()).toBe(2);
  });

  it("are not needed: a store that fails is as good as none", async () => {
    const fails: LayoutStore = { get: () => Promise.reject(new Error("no")), set: () => Promise.reject(new Error("no")) };
    expect((await keeping(engine, fails)(graph)).children?.[0]).toMatchObject({ width: 10, height: 20 });
  });

  it("are computed anew where what is kept is no layout", async () => {
    const store = table();
    const { engine, count } = counted();
    await keeping(engine, store)(graph);
    for (const [key, kept] of store.all) store.all.set(key, { ...kept, answer: "{" });
    expect((await keeping(engine, store)(graph)).children).toHaveLength(1);
    expect(count()).toBe(2);
  });

  it("leave out graphs that are very large", async () => {
    const store = table();
    const many = Array.from({ length: 2000 }, (_, i) => ({ id: `state with number ${i}`, width: 10, height: 20 }));
    const asItIs: LayoutEngine = (graph) => Promise.resolve(graph);
    await keeping(asItIs, store)(graph);
    expect(store.all.size).toBe(1);
    await keeping(asItIs, store)({ ...graph, children: many });
    expect(store.all.size).toBe(1);
  });

  it("have keys that differ for texts that differ by a letter", () => {
    const texts = Array.from({ length: 26 }, (_, i) => `state ${String.fromCharCode(97 + i)}`);
    expect(new Set(texts.map(keyOfText)).size).toBe(26);
  });
});
