// Dragging in a level of a thousand states: each frame costs what is dragged, not what stands around it.
import { describe, expect, it } from "vitest";
import { layoutModel } from "../../shared/drawing/layout";
import { mover } from "../../shared/drawing/moved";
import type { Place } from "../../shared/drawing/places";
import { sceneOf } from "../../shared/drawing/scene";
import { noWork } from "../../shared/drawing/work";
import type { State } from "../../shared/model/model";
import { buildTree } from "../../shared/model/modelTree";

const kCount = 1000;
const empty: State = { kind: "state", name: "", parameters: [], results: [], variables: [], actions: [], children: [], ports: [] };
const children = Array.from({ length: kCount }, (_, i): State => ({ ...empty, name: `S${i}`, id: `s${i}`, children: i === 5 ? [{ ...empty, name: "Inner" }] : [], ports: [{ name: "p", when: "True", to: `S${(i + 1) % kCount}` }] }));
const root: State = { ...empty, name: "Root", id: "root", first: "S0", children };
const places = new Map(children.map(({ id }, i): [string, Place] => [id ?? "", { x: 260 * (i % 32), y: 150 * Math.floor(i / 32), side: "EAST" }]));
// The state with children has one without a place, in the middle of its own level.
const engine = () => Promise.resolve({ id: "drawing", children: [{ id: "Root/S5", width: 200, height: 120, children: [{ id: "Root/S5/Inner", x: 20, y: 50 }] }] });
const drawing = await layoutModel(engine, { state: root, path: "Root", collapsed: new Set(), detail: "ports", aspect: 1.6, places });
const tree = buildTree(root);

describe("a level of a thousand states", () => {
  it("has few boxes looked at for a frame of a drag, and only what is dragged made anew", () => {
    const work = noWork();
    const move = mover(drawing, ["Root/S5"], work);
    const moved = move({ x: 40, y: 8 });
    expect(work.looks).toBeLessThan(2000);
    const changed = moved.nodes.filter((node, i) => node !== drawing.nodes[i]).map(({ path }) => path);
    expect(changed).toEqual(["Root/S5", "Root/S5/Inner"]);
    expect(moved.lines.filter((line, i) => line !== drawing.lines[i]).map(({ id }) => id)).toEqual(["Root/S4.p→S5", "Root/S5.p→S6"]);
  });
  it("has the items of what is not dragged in the scene of the next frame", () => {
    const moved = mover(drawing, ["Root/S5"])({ x: 40, y: 8 });
    const [before, after] = [sceneOf(drawing, tree), sceneOf(moved, tree)];
    const same = moved.nodes.filter(({ path }) => before.node(path) === after.node(path)).length;
    // What is in the dragged state, and it.
    expect(drawing.nodes.length - same).toBe(2);
  });
  it("is moved as a whole in one pass", () => {
    const paths = children.map(({ name }) => `Root/${name}`);
    const read = { count: 0 };
    const counted = new Proxy(paths, { get: (target, key, receiver) => (read.count++, Reflect.get(target, key, receiver) as unknown) });
    const moved = mover(drawing, counted)({ x: 16, y: 0 });
    expect(moved.nodes.every((node, i) => node.x === (drawing.nodes[i]?.x ?? 0) + (node.path === "Root" ? 0 : 16))).toBe(true);
    expect(read.count).toBeLessThan(5 * kCount);
  });
});
