import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { layoutModel } from "../../shared/drawing/layout";
import { compare } from "../../shared/edit/difference/compare";
import { editedModel } from "../../shared/edit/editedModel";
import type { Tree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import { buildTree } from "../../shared/model/modelTree";
import { ghostsOf, removedNodes, type DrawnModel } from "../../shared/versions/ghosts";
import { treeOf } from "../edit/documents";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;

const node = (name: string, more: object = {}) => ({ state: name, meta: { id: name }, ...more });
const documentOf = (...children: readonly object[]): Tree => treeOf({ rcm: 1, root: node("Root", { children }) } as unknown as JsonValue);
const port = (to: string) => [{ name: "done", when: "True", to, meta: { id: `to${to}` } }];
const before = documentOf(node("A", { ports: port("B") }), node("B", { children: [node("Inner")] }), node("C", { children: [node("D"), node("E")] }), { barrier: "Both", to: ["C"], meta: { id: "Both" } });
const after = documentOf(node("A"), node("C", { children: [node("D")] }));

async function drawn(of: Tree, collapsed: readonly string[] = []): Promise<DrawnModel> {
  const { root } = editedModel(of);
  const drawing = await layoutModel(engine, { state: root, path: "Root", collapsed: new Set(collapsed), detail: "full", aspect: 2 });
  return { tree: buildTree(root), drawing };
}
const boxOf = ({ drawing }: DrawnModel, path: string) => drawing.nodes.find((each) => each.path === path) ?? { x: NaN, y: NaN, width: 0 };

describe("what a comparison has removed", async () => {
  const compared = compare(before, after);
  const [was, now] = [await drawn(before), await drawn(after)];
  it("is the outermost states and barriers, of a state that is still there", () => {
    expect(removedNodes(compared).map(({ id, kind }) => [id, kind]).sort()).toEqual([["B", "state"], ["Both", "barrier"], ["E", "state"]]);
  });
  it("is where it was in the state around it, as large as it was", () => {
    const ghosts = ghostsOf(compared, was, now);
    expect(ghosts.map(({ name }) => name).sort()).toEqual(["B", "Both", "E"]);
    for (const { id, x, y, width } of ghosts) {
      const around = id === "E" ? "Root/C" : "Root";
      const [old, oldAround, newAround] = [boxOf(was, `${around}/${id}`), boxOf(was, around), boxOf(now, around)];
      expect([x - newAround.x, y - newAround.y, width], id).toEqual([old.x - oldAround.x, old.y - oldAround.y, old.width]);
    }
  });
  it("is not drawn in a state that is drawn closed", async () => {
    expect(ghostsOf(compared, was, await drawn(after, ["Root/C"])).map(({ id }) => id).sort()).toEqual(["B", "Both"]);
  });
});
