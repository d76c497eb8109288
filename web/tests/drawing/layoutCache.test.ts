// What is laid out once is not laid out again: not for a copy of a state, not for the next drawing, not after it was left.
import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { layoutModel, type LayoutRequest } from "../../shared/drawing/layout";
import { layoutCache } from "../../shared/drawing/layoutCache";
import type { Port, State } from "../../shared/model/model";
import { buildTree } from "../../shared/model/modelTree";

const elk = new ELK();

function counting() {
  const counts = { layouts: 0 };
  const engine: LayoutEngine = async (graph) => {
    counts.layouts++;
    return (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;
  };
  return { counts, engine };
}

const empty: State = { kind: "state", name: "Both", parameters: [], results: [], variables: [], actions: [], children: [], ports: [] };
const named = (name: string, state: State): State => ({ ...state, name });
const step = (name: string, to?: string): State => ({ ...empty, name, ports: [{ name: "done", when: "True", ...(to === undefined ? {} : { to }) }] });
const pair = (name: string): State => ({ ...step(name), first: "A", children: [step("A", "B"), step("B")] });
const part: State = { ...empty, name: "Part", first: "Go", children: [step("Go", "Pick"), pair("Pick")] };
/** The same part, as deep as this and one deeper. */
const both: State = { ...empty, children: [part, { ...empty, name: "Box", children: [part] }] };
const request = (state: State, more: Partial<LayoutRequest> = {}): LayoutRequest => ({ state, path: state.name, collapsed: new Set(), detail: "slim", aspect: 1.6, ...more });

describe("layoutCache", () => {
  it("has a state that is linked twice laid out once, and draws each with its own paths and depths", async () => {
    const [one, two] = [counting(), counting()];
    const memory = layoutCache();
    await layoutModel(one.engine, request(both), memory);
    await layoutModel(two.engine, request({ ...both, children: both.children.slice(1) }));
    expect(one.counts.layouts).toBe(two.counts.layouts);
    const drawing = await layoutModel(one.engine, request(both), memory);
    const tree = buildTree(both);
    expect(drawing.nodes.map(({ path }) => path).sort()).toEqual([...tree.keys()].sort());
    for (const node of drawing.nodes) {
      expect(node.depth, node.path).toBe(tree.get(node.path)?.depth);
      for (const port of node.ports) expect(port.address.startsWith(`${node.path}.`)).toBe(true);
    }
    expect(new Set(drawing.lines.map(({ id }) => id)).size).toBe(drawing.lines.length);
  });
  it("does not look at ids: copies look the same, though each element of each has its own", async () => {
    const copy = (name: string): State => {
      const ports = step("A", "Both").ports.map((port) => ({ ...port, id: `${name}p` }));
      const barrier = { kind: "barrier", name: "Both", to: ["B"], id: `${name}b` } as const;
      const children = [{ ...step("A"), ports, id: `${name}a` }, barrier, step("B")];
      return { ...empty, name, first: "Pair", children: [{ ...pair("Pair"), children, id: `${name}s` }], id: name };
    };
    const memory = layoutCache();
    const { counts, engine } = counting();
    await layoutModel(engine, request(copy("One")), memory);
    counts.layouts = 0;
    await layoutModel(engine, request(named("One", copy("Two"))), memory);
    expect(counts.layouts).toBe(0);
  });
  it("reuses a known drawing, and lays out only the new parts of another one", async () => {
    const { counts, engine } = counting();
    const memory = layoutCache();
    const first = await layoutModel(engine, request(part), memory);
    counts.layouts = 0;
    expect(await layoutModel(engine, request(part), memory)).toEqual(first);
    expect(counts.layouts).toBe(0);
    const work: number[] = [];
    await layoutModel(engine, request(part, { collapsed: new Set([`${part.name}/Pick`]), onProgress: (_, of) => work.push(of) }), memory);
    expect(work[0]).toBe(1);
  });
  it("distinguishes details, collapsed states and names", async () => {
    const { counts, engine } = counting();
    const memory = layoutCache();
    await layoutModel(engine, request(part), memory);
    for (const other of [request(part, { detail: "ports" }), request(part, { aspect: 1 }), request(named("Renamed", part))]) {
      counts.layouts = 0;
      await layoutModel(engine, other, memory);
      expect(counts.layouts).toBeGreaterThan(0);
    }
  });
  it("distinguishes a time-out from a condition of the same text, and from another time-out", () => {
    const memory = layoutCache();
    const ports: readonly Port[] = [{ name: "done", when: "2.5" }, { name: "done", after: "2.5" }, { name: "done", after: "3" }];
    const looks = ports.map((port) => {
      const state: State = { ...empty, ports: [port] };
      return memory.look(state, state.name, "EAST", 1, request(state));
    });
    expect(new Set(looks).size).toBe(3);
  });
  it("counts its work to the end", async () => {
    const steps: (readonly [number, number])[] = [];
    await layoutModel(counting().engine, request(both, { onProgress: (done, of) => steps.push([done, of]) }));
    const of = steps[0]?.[1] ?? 0;
    expect(of).toBeGreaterThan(2);
    expect(steps).toEqual(Array.from({ length: of + 1 }, (_, done) => [done, of]));
  });
  it("draws a part of a very large drawing the same with and without the whole in the cache", async () => {
    // Rows of four, which are worth wrapping, on three levels; no two composites look alike.
    const row = (name: string, levels: number, to?: string): State => {
      const names = ["A", "B", "C", "D"].map((letter) => name + letter);
      const children = names.map((child, i) => (levels === 1 ? step(child, names[i + 1]) : row(child, levels - 1, names[i + 1])));
      return { ...step(name, to), first: `${name}A`, children };
    };
    const inner = row("Inner", 3);
    const whole: State = { ...empty, name: "Whole", children: [inner] };
    const { engine } = counting();
    const fresh = (state: State) => layoutModel(engine, request(state, { onProgress: (_, of) => expect(of, state.name).toBeGreaterThan(40) }));
    const alone = [await fresh(whole), await fresh(inner)] as const;
    const [once, otherwise] = [layoutCache(), layoutCache()];
    await layoutModel(engine, request(whole), once);
    expect(await layoutModel(engine, request(inner), once)).toEqual(alone[1]);
    await layoutModel(engine, request(inner), otherwise);
    expect(await layoutModel(engine, request(whole), otherwise)).toEqual(alone[0]);
  });
  it("clears its table when it is full, and never gives a key twice", () => {
    const memory = layoutCache({ blocks: 10, words: 10 });
    const look = (state: State) => memory.look(state, state.name, "EAST", 1, request(state));
    const [first, again] = [look(step("S0")), look(step("S0"))];
    expect(again).toBe(first);
    const others = Array.from({ length: 25 }, (_, i) => look(step(`S${i + 1}`)));
    const later = look(step("S0"));
    expect(later).not.toBe(first);
    expect(new Set([first, later, ...others]).size).toBe(27);
  });
  it("stops when it is aborted, and keeps no incomplete choice", async () => {
    const memory = layoutCache();
    const left = new AbortController();
    const { counts, engine } = counting();
    const leaving: LayoutEngine = (graph) => {
      if (counts.layouts === 2) left.abort(new Error("left"));
      return engine(graph);
    };
    await expect(layoutModel(leaving, request(both, { signal: left.signal }), memory)).rejects.toThrow("left");
    const whole = await layoutModel(engine, request(both));
    expect(counts.layouts).toBeGreaterThan(6);
    expect(await layoutModel(engine, request(both), memory)).toEqual(whole);
  });
});
