import { describe, expect, it } from "vitest";
import { apply, type Operation } from "../../shared/edit/apply";
import { editedModel, editedState } from "../../shared/edit/editedModel";
import { Refusal } from "../../shared/edit/refusal";
import type { Tree } from "../../shared/edit/tree";
import { carried, carriedPath, idAt } from "../../shared/model/identity";
import { buildTree, portAt, stateAt, type ModelTree } from "../../shared/model/modelTree";
import { applyGesture, initialView } from "../../shared/session/view";
import { treeOf } from "./documents";

const id = (name: string) => ({ meta: { id: name } });
const document = treeOf({
  rcm: 1,
  services: { robot: "robot" },
  root: {
    state: "Root", ...id("root"), first: "A",
    children: [
      { state: "A", ...id("a"), ports: [{ name: "done", when: "True", to: "B", ...id("a-done") }, { name: "done", ...id("a-done2") }] },
      { state: "B", ...id("b"), ports: [{ name: "late", after: "2.0", ...id("b-late") }] },
      { state: "A", ...id("a2") },
      { barrier: "Both", to: ["A"], ...id("both") },
    ],
  },
});

function edited(tree: Tree, ...operations: Operation[]): Tree {
  const result = apply(tree, { operations });
  if (result instanceof Refusal) throw result;
  return result.tree;
}
const modelTree = (tree: Tree): ModelTree => buildTree(editedState(tree, tree.root));

describe("the model of an edited document", () => {
  const tree = modelTree(document);
  it("has what a draft lacks as empty", () => {
    expect(portAt(tree, "Root/A.done#2")).toMatchObject({ name: "done", when: "" });
    expect(portAt(tree, "Root/B.late")).toMatchObject({ after: "2.0" });
    expect(editedModel(document).services).toEqual({ robot: "robot" });
  });
  it("tells siblings with one name apart", () => {
    expect([...tree.keys()]).toEqual(["Root", "Root/A", "Root/B", "Root/A#2", "Root/Both"]);
    expect(stateAt(tree, "Root/A#2")).toMatchObject({ id: "a2", name: "A" });
    expect(idAt(tree, { kind: "port", address: "Root/A.done#2" })).toBe("a-done2");
  });
  it("gives what did not change as the object that it was", () => {
    const after = edited(document, { op: "set", id: "b", field: "doc", value: "waits" });
    const [before, now] = [editedState(document, "root"), editedState(after, "root")];
    expect(now).not.toBe(before);
    expect(now.children.map((child, i) => child === before.children[i])).toEqual([true, false, true, true]);
    expect(editedState(after, "root")).toBe(now);
  });
});

describe("the view of a document", () => {
  const after = edited(document, { op: "set", id: "a", field: "state", value: "Grasp" }, { op: "move", id: "b", parent: "a", list: "children" });
  const [before, now] = [modelTree(document), modelTree(after)];
  it("follows elements that are renamed and moved", () => {
    expect(carriedPath(before, now, "Root/B")).toBe("Root/Grasp/B");
    expect(carried(before, now, { kind: "port", address: "Root/B.late" })).toEqual({ kind: "port", address: "Root/Grasp/B.late" });
    const view = { ...initialView, page: "edit", selection: { kind: "node", path: "Root/A" }, also: new Set(["Root/B"]), collapsed: new Set(["Root/A"]) } as const;
    expect(applyGesture(view, { type: "carry", of: "document", before, after: now })).toMatchObject({ selection: { path: "Root/Grasp" }, also: new Set(["Root/Grasp/B"]), collapsed: new Set(["Root/Grasp"]) });
  });
  it("forgets what is removed, and keeps the places of the run", () => {
    const without = modelTree(edited(document, { op: "remove", id: "a" }));
    const editing = applyGesture({ ...initialView, focus: "Root/Run" }, { type: "page", page: "edit" });
    const view = applyGesture(editing, { type: "select", selection: { kind: "node", path: "Root/A" } });
    const gone = applyGesture(view, { type: "carry", of: "document", before, after: without });
    expect(gone.selection).toBeUndefined();
    expect(applyGesture(gone, { type: "page", page: "task" }).focus).toBe("Root/Run");
  });
  it("carries the places of the run when its model changes, and keeps those of the document", () => {
    const shown = applyGesture({ ...initialView, focus: "Root/B", selection: { kind: "node", path: "Root/A" } }, { type: "carry", of: "run", before, after: now });
    expect(shown).toMatchObject({ focus: "Root/Grasp/B", selection: { kind: "node", path: "Root/Grasp" } });
    const editing = applyGesture({ ...initialView, focus: "Root/B" }, { type: "page", page: "edit" });
    const selected = applyGesture(editing, { type: "select", selection: { kind: "node", path: "Root/A" } });
    const both = applyGesture(selected, { type: "carry", of: "run", before, after: now });
    expect(both.selection).toEqual({ kind: "node", path: "Root/A" });
    expect(applyGesture(both, { type: "page", page: "task" }).focus).toBe("Root/Grasp/B");
  });
  it("leaves what is shown of a run that comes meanwhile to the page of the run", () => {
    const editing = applyGesture({ ...initialView, focus: "Root/Run" }, { type: "page", page: "edit" });
    const view = applyGesture({ ...editing, focus: "Root/A" }, { type: "show_run", shown: { focus: undefined, collapsed: new Set(["Root/Large"]), detail: "auto" } });
    expect(view.focus).toBe("Root/A");
    expect(applyGesture(view, { type: "page", page: "task" })).toMatchObject({ focus: undefined, collapsed: new Set(["Root/Large"]) });
  });
  it("selects several nodes, and takes them out again", () => {
    const first = applyGesture(initialView, { type: "select_also", path: "Root/A" });
    const both = applyGesture(first, { type: "select_also", path: "Root/B" });
    expect([both.selection, both.also]).toEqual([{ kind: "node", path: "Root/A" }, new Set(["Root/B"])]);
    expect(applyGesture(both, { type: "select_also", path: "Root/A" }).selection).toEqual({ kind: "node", path: "Root/B" });
  });
});
