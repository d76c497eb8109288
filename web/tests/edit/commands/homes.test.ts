import { describe, expect, it } from "vitest";
import { homesFor } from "../../../shared/edit/commands/homes";
import { treeOf } from "../documents";
import { document } from "./fixture";

describe("states to move into", () => {
  const paths = (ids: readonly string[]) => homesFor(document, ids).shown.map(({ path }) => path);

  it("are told by their paths, the nearest first, also of the library", () => {
    expect(paths(["d"])).toEqual(["Root", "Root/C/E", "Root/A", "Root/B", "library/Pick"]);
  });
  it("are not where it is, itself or in itself, nor what links the library", () => {
    expect(paths(["c"])).toEqual(["Root/A", "Root/B", "library/Pick"]);
    expect(paths(["root"])).toEqual([]);
  });
  it("of one name are told apart, and of very many some are shown and the others counted", () => {
    const same = Array.from({ length: 2000 }, (_, i) => ({ state: `S${i}`, meta: { id: `s${i}` }, first: "In", children: [{ state: "In", meta: { id: `in${i}` } }] }));
    const tree = treeOf({ rcm: 1, root: { state: "Root", meta: { id: "root" }, first: "S0", children: same } });
    const { shown, more } = homesFor(tree, ["in7"]);
    expect(shown.length + more).toBe(3999);
    expect([shown.length, new Set(shown.map(({ path }) => path)).size]).toEqual([40, 40]);
    expect(shown[0]?.path).toBe("Root");
  });
});
