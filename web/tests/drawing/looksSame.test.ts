// After an edit all but what it changes is the same object, looks the same, and need not be painted again.
import { describe, expect, it } from "vitest";
import { layoutModel } from "../../shared/drawing/layout";
import { layoutCache } from "../../shared/drawing/layoutCache";
import { looksSame } from "../../shared/drawing/looksSame";
import type { Place } from "../../shared/drawing/places";
import { sceneOf } from "../../shared/drawing/scene";
import type { State } from "../../shared/model/model";
import { buildTree } from "../../shared/model/modelTree";

const empty: State = { kind: "state", name: "", parameters: [], results: [], variables: [], actions: [], children: [], ports: [] };
const step = (id: string, name: string, to?: string): State => ({ ...empty, id, name, ports: [{ name: "done", when: "True", ...(to !== undefined && { to }) }] });
const part = (id: string, to?: string): State => ({ ...step(id, `Part${id}`, to), first: "A", children: [step(`${id}a`, "A", "B"), step(`${id}b`, "B")] });
const root: State = { ...empty, id: "root", name: "Root", first: "Part1", children: [part("1", "Part2"), part("2", "Part3"), part("3")] };
const places = new Map<string, Place>(["1", "2", "3"].flatMap((id, i): [string, Place][] => [
  [id, { x: 900 * i, y: 0, side: "EAST" }], [`${id}a`, { x: 0, y: 0, side: "EAST" }], [`${id}b`, { x: 300, y: 0, side: "EAST" }],
]));
const engine = () => Promise.reject(new Error("all is placed"));
const memory = layoutCache();
const draw = (state: State, at: ReadonlyMap<string, Place>) => layoutModel(engine, { state, path: "Root", collapsed: new Set(), detail: "ports", aspect: 1.6, places: at }, memory);
const tree = buildTree(root);

describe("a drawing after an edit", () => {
  it("looks as before but where something has moved, and has made nothing else anew", async () => {
    const before = await draw(root, places);
    const after = await draw(root, new Map(places).set("2b", { x: 280, y: 0, side: "EAST" }));
    const known = new Set<unknown>(before.nodes);
    expect(after.nodes.filter((node) => !known.has(node)).map(({ path }) => path)).toEqual(["Root", "Root/Part2", "Root/Part2/A", "Root/Part2/B"]);
    const [was, is] = [sceneOf(before, tree), sceneOf(after, tree)];
    const same = (path: string) => {
      const node = after.nodes.find((each) => each.path === path);
      if (node === undefined) throw new Error(path);
      return looksSame(was, is, node, 1);
    };
    // A line leads from Part2 to the border of Part3.
    expect(["Root/Part1", "Root/Part3/B", "Root/Part3", "Root/Part2"].map(same)).toEqual([true, true, false, false]);
    // What is too small to be painted makes no difference.
    expect(looksSame(was, is, { x: 0, y: 0, width: before.width, height: before.height }, 0.01)).toBe(true);
  });
  it("differs where a port has another name, and nowhere else", async () => {
    const before = await draw(root, places);
    const renamed: State = { ...root, children: root.children.map((child) => (child.kind === "state" && child.id === "3" ? { ...child, ports: [{ name: "over", when: "True" }] } : child)) };
    const after = await draw(renamed, places);
    const [was, is] = [sceneOf(before, tree), sceneOf(after, buildTree(renamed))];
    const boxOf = (path: string) => after.nodes.find((node) => node.path === path) ?? { x: 0, y: 0, width: 0, height: 0 };
    expect(looksSame(was, is, boxOf("Root/Part1"), 1)).toBe(true);
    const { ports } = after.nodes.find((node) => node.path === "Root/Part3") ?? { ports: [] };
    expect(ports.map((port) => looksSame(was, is, port, 1))).toEqual([false]);
  });
});
