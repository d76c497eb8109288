// Levels in which somebody has placed states: those stay, the others give way, lines lead around, and the work is bounded.
import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import type { Box, Drawing, DrawnNode, Point } from "../../shared/drawing/drawing";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { layoutModel } from "../../shared/drawing/layout";
import { layoutCache } from "../../shared/drawing/layoutCache";
import { placesIn, type Place, type Places } from "../../shared/drawing/places";
import { placedLevel, type PlacedChild } from "../../shared/drawing/placed";
import { crossings } from "../../shared/drawing/route";
import { hullOf, inletPoint } from "../../shared/drawing/levelLines";
import { leafBoxes } from "../../shared/drawing/measure";
import { settle } from "../../shared/drawing/settle";
import { spatialIndex } from "../../shared/drawing/spatialIndex";
import { noWork } from "../../shared/drawing/work";
import type { State } from "../../shared/model/model";
import { randomOf, type Random } from "../edit/random";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;
const noEngine: LayoutEngine = () => Promise.reject(new Error("ELK was asked"));

const empty: State = { kind: "state", name: "", parameters: [], results: [], variables: [], actions: [], children: [], ports: [] };
const step = (name: string, to: readonly string[], children: readonly State[] = []): State => ({
  ...empty, name, id: `id-${name}`, children, ...(children[0] && { first: children[0].name }),
  ports: to.map((target, i) => ({ name: `p${i}`, when: "True", ...(target !== "" && { to: target }) })),
});
const rootOf = (children: readonly State[]): State => ({ ...step("Root", [], children), ports: [{ name: "done", when: "chi.A.port.p0" }, { name: "late", after: "2" }] });
const names = ["A", "B", "C", "D", "E", "F"];

function randomRoot(random: Random): State {
  const count = 2 + random.pick(5);
  const own = names.slice(0, count);
  return rootOf(own.map((name) => step(name, Array.from({ length: random.pick(3) }, () => (random.chance(0.8) ? random.of(own) : "")), random.chance(0.2) ? [step("X", ["Y"]), step("Y", [])] : [])));
}

const draw = (state: State, places: Places, by = engine, memory = layoutCache()): Promise<Drawing> =>
  layoutModel(by, { state, path: state.name, collapsed: new Set(), detail: "ports", aspect: 1.6, places }, memory);

const overlap = (a: Box, b: Box) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
/** ELK's lines are up to half a pixel beside a port. */
function expectNear(a: Point | undefined, b: Point, what: string): void {
  expect(Math.hypot((a?.x ?? Infinity) - b.x, (a?.y ?? Infinity) - b.y), what).toBeLessThan(1);
}
const hull = (node: DrawnNode): Box => hullOf({ box: node, ports: node.ports });
const node = (drawing: Drawing, path: string): DrawnNode => drawing.nodes.find((each) => each.path === path) ?? expect.fail(path);

/** Where a node is in the content area of its parent. */
function placeOfDrawn(drawing: Drawing, path: string) {
  const [inner, parent] = [node(drawing, path), node(drawing, path.slice(0, path.lastIndexOf("/")))];
  return { x: inner.x - parent.x - (parent.content?.x ?? 0), y: inner.y - parent.y - (parent.content?.y ?? 0) };
}

describe.each(Array.from({ length: 25 }, (_, seed) => seed))("a random level (seed %i)", async (seed) => {
  const random = randomOf(seed);
  const root = randomRoot(random);
  const places = new Map(root.children.filter(() => random.chance(0.5)).map((child): [string, Place] => [child.id ?? "", { x: random.pick(900) - 100, y: random.pick(600) - 100, side: random.chance(0.9) ? "EAST" : "SOUTH" }]));
  const drawing = await draw(root, places);
  const own = drawing.nodes.filter((each) => each.depth === 1);
  const isPlaced = ({ path }: DrawnNode) => places.has(`id-${path.slice("Root/".length)}`);

  it("has what was placed exactly there", () => {
    for (const [id, { x, y, side }] of places) {
      const path = `Root/${id.slice("id-".length)}`;
      expect(placeOfDrawn(drawing, path)).toEqual({ x, y });
      expect(node(drawing, path).side).toBe(side);
    }
  });
  it("has no two boxes over each other, unless both were placed so", () => {
    for (const [i, a] of own.entries()) for (const b of own.slice(i + 1)) if (!(isPlaced(a) && isPlaced(b))) expect(overlap(hull(a), hull(b)), `${a.path} and ${b.path}`).toBe(false);
  });
  it("has all in its frame, whose ports are in order", () => {
    const frame = node(drawing, "Root");
    for (const inner of own) {
      const { x, y, width, height } = hull(inner);
      expect(x >= frame.x && y >= frame.y && x + width <= frame.x + frame.width && y + height <= frame.y + frame.height, inner.path).toBe(true);
    }
    expect(frame.ports.map(({ name }) => name)).toEqual(["done", "late"]);
    expect((frame.ports[0]?.y ?? 0) < (frame.ports[1]?.y ?? 0)).toBe(true);
  });
  it("has lines that begin and end at their ports and run along the axes", () => {
    const ports = new Map(drawing.nodes.flatMap((each) => each.ports.map((port) => [port.address, { ...port, side: each.side }] as const)));
    for (const { id, kind, from, to = "", points } of drawing.lines) {
      const port = ports.get(from);
      if (port !== undefined) expectNear(points[0], port.side === "EAST" ? { x: port.x + port.width, y: port.y + port.height / 2 } : { x: port.x + port.width / 2, y: port.y + port.height }, id);
      if (kind === "transition") {
        const target = node(drawing, to);
        const inlet = inletPoint(target, target.side);
        expectNear(points.at(-1), { x: target.x + inlet.x, y: target.y + inlet.y }, id);
      }
      points.slice(1).forEach((point, i) => expect(Math.abs(point.x - (points[i]?.x ?? 0)) < 1 || Math.abs(point.y - (points[i]?.y ?? 0)) < 1, `${id} is slanted`).toBe(true));
    }
  });
  it("is the same each time, also from the cache", async () => {
    const memory = layoutCache();
    expect(await draw(root, places, engine, memory)).toEqual(drawing);
    expect(await draw(root, places, noEngine, memory)).toEqual(drawing);
  });
});

describe("a level with places", () => {
  const root = rootOf([step("A", ["B"]), step("B", ["C"]), step("C", ["A"])]);
  it("is not laid out by ELK if all is placed", async () => {
    const places = new Map(root.children.map(({ id }, i) => [id ?? "", { x: 300 * i, y: 0, side: "EAST" } as const]));
    expect((await draw(root, places, noEngine)).lines.length).toBe(5);
  });
  it("leaves what is automatic where it was when one state is placed there", async () => {
    const before = await draw(root, new Map());
    const { side } = node(before, "Root/B");
    const after = await draw(root, new Map([["id-B", { ...placeOfDrawn(before, "Root/B"), y: 400, side }]]));
    for (const path of ["Root/A", "Root/C"]) expect(placeOfDrawn(after, path)).toEqual(placeOfDrawn(before, path));
  });
  it("leads lines around boxes that stand apart", async () => {
    const places = new Map<string, Place>([["id-A", { x: 0, y: 0, side: "EAST" }], ["id-C", { x: 250, y: 0, side: "EAST" }], ["id-B", { x: 500, y: 0, side: "EAST" }]]);
    const drawing = await draw(root, places);
    const boxes = drawing.nodes.filter((each) => each.depth === 1);
    for (const line of drawing.lines.filter(({ kind }) => kind === "transition")) expect(crossings(spatialIndex<Box>(boxes), line.points), line.id).toBe(0);
  });
  it("has places of other parents ignored, and those in another cache entry", async () => {
    const memory = layoutCache();
    const automatic = await draw(root, new Map(), engine, memory);
    expect(await draw(root, new Map([["id-A", { x: 900, y: 0, side: "EAST", parent: "id-Other" }]]), engine, memory)).toEqual(automatic);
    expect(placeOfDrawn(await draw(root, new Map([["id-A", { x: 900, y: 0, side: "EAST" }]]), engine, memory), "Root/A").x).toBe(900);
  });
});

describe("placesIn", () => {
  it("reads what is a place, and nothing else", () => {
    const layout = { a: { x: 1, y: 2 }, b: { x: 1, y: 2, side: "SOUTH", parent: "r", colour: "red" }, "Root/A": 3, c: { x: "1", y: 2 }, d: { x: 1e300, y: 0 } };
    expect([...placesIn(layout)]).toEqual([["a", { x: 1, y: 2, side: "EAST" }], ["b", { x: 1, y: 2, side: "SOUTH", parent: "r" }]]);
    expect(placesIn(layout)).toBe(placesIn(layout));
  });
});

describe("work", () => {
  const levelOf = (count: number, pinned: boolean, row: number) => {
    const states = Array.from({ length: count }, (_, i) => step(`S${i}`, [`S${(i * 7 + 1) % count}`]));
    const children = states.map((each, i): PlacedChild => ({ node: each, path: `Root/${each.name}`, ...leafBoxes(each, "EAST", "ports"), side: "EAST", at: { x: 260 * (i % row), y: 90 * Math.floor(i / row) }, pinned }));
    return { root: step("Root", [], states), children };
  };
  const workOf = (count: number, row = 45) => {
    const work = noWork();
    const { root, children } = levelOf(count, true, row);
    placedLevel(root, "Root", "EAST", "ports", children, new Map(), work);
    return work;
  };
  it("grows with the number of placed children, and not faster", () => {
    expect(workOf(2000).steps).toBeLessThan(150_000 + 100 * 2000);
    expect(workOf(2000).looks).toBeLessThan(2.5 * workOf(1000).looks);
  });
  it("ends with the boxes that tell which way is best, in a long row too", () => {
    expect(workOf(1000).looks).toBeLessThan(550_000);
    expect(workOf(1000, 1000).looks).toBeLessThan(4_500_000);
  });
  it("is bounded for boxes that all want the same place", () => {
    const boxes = Array.from({ length: 500 }, () => ({ x: 0, y: 0, width: 100, height: 60 }));
    const work = noWork();
    const found = settle(boxes.slice(0, 1), boxes.slice(1), work).map((at) => ({ ...at, width: 100, height: 60 }));
    expect(work.steps).toBeLessThan(500 * 82);
    for (const [i, a] of found.entries()) for (const b of found.slice(i + 1)) expect(overlap(a, b)).toBe(false);
  });
});
