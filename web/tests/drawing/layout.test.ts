// The drawing is checked for what a reader relies on, on every conformance model.
import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import { linesOf } from "../../shared/drawing/compositeGraph";
import type { Box, Drawing, DrawnNode, Point } from "../../shared/drawing/drawing";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { flowLines } from "../../shared/drawing/flow";
import { layoutModel } from "../../shared/drawing/layout";
import { stubs } from "../../shared/drawing/stubs";
import type { State } from "../../shared/model/model";
import { buildTree } from "../../shared/model/modelTree";
import { caseNames, modelOf } from "../conformance";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;

function draw(name: string, detail: "full" | "slim" = "full", collapsed: readonly string[] = []): Promise<Drawing> {
  const { root } = modelOf(name);
  return layoutModel(engine, { state: root, path: root.name, collapsed: new Set(collapsed), detail, aspect: 1.6 });
}

const inside = (inner: Box, outer: Box) =>
  inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width && inner.y + inner.height <= outer.y + outer.height;

const overlap = (a: Box, b: Box) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

const near = (p: Point | undefined, box: Box, by: number) =>
  p !== undefined && p.x >= box.x - by && p.y >= box.y - by && p.x <= box.x + box.width + by && p.y <= box.y + box.height + by;

function parentOf(drawing: Drawing, node: DrawnNode): DrawnNode | undefined {
  return drawing.nodes.find((other) => other.path === node.path.slice(0, node.path.lastIndexOf("/")));
}

/** A state with its ports: what must not be covered by a sibling. */
function hull(node: DrawnNode): readonly Box[] {
  return [node, ...node.ports];
}

describe.each(caseNames)("%s", async (name) => {
  const drawing = await draw(name);
  it("shows every node once, inside its parent", () => {
    expect(drawing.nodes.map((node) => node.path).sort()).toEqual([...buildTree(modelOf(name).root).keys()].sort());
    for (const node of drawing.nodes) {
      const parent = parentOf(drawing, node);
      if (parent !== undefined) expect(inside(node, parent), node.path).toBe(true);
    }
  });
  it("keeps siblings and their ports apart", () => {
    for (const a of drawing.nodes) {
      for (const b of drawing.nodes) {
        if (a.path >= b.path || parentOf(drawing, a) !== parentOf(drawing, b)) continue;
        for (const x of hull(a)) for (const y of hull(b)) expect(overlap(x, y), `${a.path} and ${b.path}`).toBe(false);
      }
    }
  });
  it("puts every port on the border of its state", () => {
    for (const node of drawing.nodes) {
      for (const port of node.ports) {
        const border = node.side === "EAST" ? node.x + node.width : node.y + node.height;
        const [from, to] = node.side === "EAST" ? [port.x, port.x + port.width] : [port.y, port.y + port.height];
        expect(from < border && border < to, port.address).toBe(true);
      }
    }
  });
  it("draws every transition, fork, first and exit, from its port to its target", () => {
    const boxes = new Map<string, Box>(drawing.nodes.flatMap((node) => [[node.path, node] as const, ...node.ports.map((p) => [p.address, p] as const)]));
    const wanted = [...buildTree(modelOf(name).root).values()].flatMap(({ node, path }) => (node.kind === "state" ? linesOf(node, path) : []));
    expect(drawing.lines.map((line) => line.id).sort()).toEqual(wanted.map((line) => line.id).sort());
    for (const line of drawing.lines) {
      const source = boxes.get(line.from);
      const target = boxes.get(line.to ?? "");
      if (source === undefined || target === undefined) throw new Error(`${line.id} has an end that is not drawn`);
      expect(near(line.points[0], source, 1), `start of ${line.id}`).toBe(true);
      expect(near(line.points.at(-1), target, 1), `end of ${line.id}`).toBe(true);
    }
  });
});

describe("layoutModel", () => {
  it("draws the bar and both branches of a fork (Fig. 3.6)", async () => {
    const lines = (await draw("thesis-collision-history")).lines.filter((line) => line.kind === "fork");
    expect(lines.map((line) => line.to)).toEqual(["Root/Collision/Haptic", "Root/Collision/Display"]);
  });
  it("hides the children of a collapsed state and keeps its ports", async () => {
    const drawing = await draw("thesis-collision-history", "full", ["Root/Pick"]);
    expect(drawing.nodes.some((node) => node.path.startsWith("Root/Pick/"))).toBe(false);
    expect(drawing.nodes.find((node) => node.path === "Root/Pick")?.ports.map((port) => port.name)).toEqual(["success", "error", "collision"]);
  });
  it("needs less room with less detail", async () => {
    const [full, slim] = [await draw("thesis-collision-history"), await draw("thesis-collision-history", "slim")];
    expect(slim.width * slim.height).toBeLessThan(0.6 * full.width * full.height);
  });
  it("takes a time that grows with the model, not twofold with each level", async () => {
    const nested = (levels: number): State => ({ ...modelOf("hierarchy-first").root, children: levels === 0 ? [] : [nested(levels - 1)], name: `L${levels}`, ports: [] });
    let layouts = 0;
    const counted: LayoutEngine = (graph) => (++layouts, engine(graph));
    await layoutModel(counted, { state: nested(9), path: "L9", collapsed: new Set(), detail: "slim", aspect: 1.6 });
    expect(layouts).toBeLessThanOrEqual(4 * 9);
  });
  it("says why when there is no layout at all, and does without an arrangement that fails", async () => {
    const { root } = modelOf("hierarchy-first");
    const request = { state: root, path: root.name, collapsed: new Set<string>(), detail: "slim", aspect: 1.6 } as const;
    await expect(layoutModel(() => Promise.reject(new Error("no worker")), request)).rejects.toThrow("no worker");
    let first = true;
    const stumbling: LayoutEngine = (graph) => (first ? ((first = false), Promise.reject(new Error("stumbled"))) : engine(graph));
    expect((await layoutModel(stumbling, request)).nodes.length).toBeGreaterThan(1);
  });
  it("draws a port with a time-out as such, without a line from a child", async () => {
    const ports = [{ name: "late", after: "par.timeout" }, { name: "done", when: "chi.A.port.done" }];
    const child: State = { kind: "state", name: "A", parameters: [], results: [], variables: [], actions: [], children: [], ports: [{ name: "done", when: "True" }] };
    const root: State = { ...child, name: "Root", first: "A", children: [child], ports };
    const drawing = await layoutModel(engine, { state: root, path: "Root", collapsed: new Set(), detail: "full", aspect: 1.6 });
    const drawn = drawing.nodes[0]?.ports.map(({ name, condition, when, timed }) => [name, condition, when, timed]);
    expect(drawn).toEqual([["late", "after par.timeout s", "after par.timeout s", true], ["done", "chi.A.port.done", "chi.A.port.done", false]]);
    expect(drawing.lines.map(({ kind, to }) => [kind, to])).toEqual([["first", "Root/A"], ["exit", "Root.done"]]);
  });
  it("gives a stub to exactly the ports that lead nowhere and that no parent names", async () => {
    const drawing = await draw("thesis-search-object-found");
    const loose = stubs(drawing).map((line) => line.from);
    expect(loose).toContain("SearchObject/HapticGesture.x_plus");
    expect(loose).not.toContain("SearchObject/HapticGesture.z_minus");
    expect(flowLines(drawing).length).toBe(drawing.lines.length + loose.length);
  });
});
