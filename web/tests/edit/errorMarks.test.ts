import { describe, expect, it } from "vitest";
import type { ServerError } from "../../generated/messages";
import { editedState } from "../../shared/edit/editedModel";
import { errorMarks, spotOf } from "../../shared/edit/errorMarks";
import { Refusal } from "../../shared/edit/refusal";
import { readTree, type Tree } from "../../shared/edit/tree";
import { buildTree } from "../../shared/model/modelTree";

const id = (name: string) => ({ meta: { id: name } });

function documentTree(): Tree {
  const tree = readTree({
    rcm: 1,
    library: [{ state: "Grasp", children: [{ state: "Close", ...id("close") }], ...id("grasp") }],
    root: {
      state: "Root",
      parameters: [{ name: "speed", ...id("speed") }],
      children: [
        { state: "A", ports: [{ name: "done", when: "", ...id("done") }], ...id("a") },
        { state: "A", ...id("a2") },
        { barrier: "Join", to: [], ...id("join") },
      ],
      ...id("root"),
    },
  });
  if (tree instanceof Refusal) throw tree;
  return tree;
}

const at = (path: string, message = "wrong"): ServerError => ({ path, code: "type", message });

describe("the element that an error is about", () => {
  const tree = documentTree();
  const spot = (error: ServerError) => spotOf(tree, error);
  it("is a node or a port", () => {
    expect([spot(at("Root/A")).id, spot(at("Root/A.done")).id, spot(at("Root/Join")).id]).toEqual(["a", "done", "join"]);
  });
  it("is the state that has a parameter, a result or an action, which are not drawn", () => {
    expect(spot(at("Root", "parameter `speed`: the root has no parent"))).toEqual({ id: "root", top: undefined });
  });
  it("is the state of a port that is not there, and the root for the document", () => {
    expect([spot(at("Root/A.nothing")).id, spot(at("")).id]).toEqual(["a", "root"]);
  });
  it("may be in the library, which is shown state by state", () => {
    expect(spot(at("library/Grasp/Close"))).toEqual({ id: "close", top: "grasp" });
    expect(spot(at("library/Grasp"))).toEqual({ id: "grasp", top: "grasp" });
  });
});

describe("the marks of errors", () => {
  const tree = documentTree();
  const errors = [at("Root/A"), at("Root/A.done"), at("Root/A.done"), at("Root"), at("library/Grasp/Close")];
  it("count at a port and at its node, and in all that they are in", () => {
    const { own, inside } = errorMarks(tree, errors, buildTree(editedState(tree, tree.root)));
    expect(Object.fromEntries(own)).toEqual({ Root: 1, "Root/A": 3, "Root/A.done": 2 });
    expect(Object.fromEntries(inside)).toEqual({ Root: 3 });
  });
  it("are those of what is shown", () => {
    const { own, inside } = errorMarks(tree, errors, buildTree(editedState(tree, "grasp")));
    expect([Object.fromEntries(own), Object.fromEntries(inside)]).toEqual([{ "Grasp/Close": 1 }, { Grasp: 1 }]);
  });
});
