import { describe, expect, it } from "vitest";
import { remove } from "../../../shared/edit/commands/remove";
import { addLibraryState } from "../../../shared/edit/commands/add";
import { treeOf } from "../documents";
import { after, childrenOf, document, field, reasonOf } from "./fixture";

describe("deleting", () => {
  it("takes out what leads to the state: ports, barriers and first", () => {
    const tree = after(remove(document, ["a"]));
    expect(childrenOf(tree, "root")).toEqual(["B", "C", "Both", "L"]);
    expect(field(tree, "root", "first")).toBeUndefined();
    expect(field(tree, "both", "to")).toEqual(["C"]);
    expect(field(after(remove(document, ["b"])), "a-done", "to")).toBeUndefined();
    expect(field(after(remove(document, ["both"])), "b-done", "to")).toBeUndefined();
  });
  it("deletes several, also one inside of another, in one edit", () => {
    const tree = after(remove(document, ["d", "c", "a"]));
    expect(childrenOf(tree, "root")).toEqual(["B", "Both", "L"]);
    expect(field(tree, "both", "to")).toEqual([]);
  });
  it("deletes a port, not its state", () => {
    const tree = after(remove(document, ["a-done"]));
    expect(tree.elements.has("a-done")).toBe(false);
    expect(tree.elements.has("a")).toBe(true);
  });
  it("leaves a name that another sibling has, too", () => {
    const twins = treeOf({
      rcm: 1,
      root: { state: "R", meta: { id: "r" }, first: "A", children: [{ state: "A", meta: { id: "a1" } }, { state: "A", meta: { id: "a2" } }] },
    });
    expect(field(after(remove(twins, ["a1"]), twins), "r", "first")).toBe("A");
  });
  it("keeps the root, and a library state that is linked", () => {
    expect(reasonOf(remove(document, ["root"]))).toBe("a document has a root");
    expect(reasonOf(remove(document, ["pick"]))).toBe("it is linked by L");
    const unused = after(addLibraryState(document, () => "unused"));
    expect(after(remove(unused, ["unused"]), unused).library).toEqual(["pick"]);
  });
});
