// Commands about places and notes change the entries of the document that are meant, and nothing else; and a drawing follows a drag.
import { describe, expect, it } from "vitest";
import { layoutModel } from "../../../shared/drawing/layout";
import { mover } from "../../../shared/drawing/moved";
import { placesIn } from "../../../shared/drawing/places";
import { apply, type Operation } from "../../../shared/edit/apply";
import { keepLayout, layOutAnew, moveNodes, notesOf, placeOf, wayOnGrid, writeNote } from "../../../shared/edit/commands/placing";
import type { Command } from "../../../shared/edit/commands/command";
import { editedState } from "../../../shared/edit/editedModel";
import { Refusal } from "../../../shared/edit/refusal";
import { readTree, type Tree } from "../../../shared/edit/tree";
import { buildTree } from "../../../shared/model/modelTree";

const layout = { a: { x: 0, y: 0, colour: "red" }, b: { x: 200, y: 0 }, other: { x: 1, y: 1 } };
const port = { name: "done", when: "True", to: "B", meta: { id: "p" } };
const children = [{ state: "A", ports: [port], meta: { id: "a" } }, { state: "B", meta: { id: "b" } }];
const document = ((): Tree => {
  const tree = readTree({ rcm: 1, root: { state: "Root", first: "A", children, meta: { id: "r" } }, layout, meta: { notes: { a: "first" } } });
  if (tree instanceof Refusal) throw tree;
  return tree;
})();

const operationsOf = (command: Command): readonly Operation[] => ("change" in command && "operations" in command.change ? (command.change.operations as readonly Operation[]) : []);

async function drawn(tree: Tree) {
  const state = editedState(tree, "r");
  const engine = () => Promise.reject(new Error("all is placed"));
  return { model: buildTree(state), drawing: await layoutModel(engine, { state, path: "Root", collapsed: new Set(), detail: "ports", aspect: 1.6, places: placesIn(tree.fields["layout"]) }) };
}

function after(command: Command): Tree {
  const applied = apply(document, { operations: [...operationsOf(command)] });
  if (applied instanceof Refusal) throw applied;
  return applied.tree;
}

describe("commands about places", () => {
  it("move several nodes with one edit, and say in which state", async () => {
    const { drawing, model } = await drawn(document);
    const moved = after(moveNodes(drawing, model, ["Root/A", "Root/B"], { x: 9, y: 50 }));
    expect(moved.fields["layout"]).toMatchObject({ a: { x: 9, y: 50, side: "EAST", parent: "r" }, b: { x: 209, y: 50, side: "EAST", parent: "r" }, other: { x: 1, y: 1 } });
  });
  it("lead onto the grid from wherever a node is", async () => {
    const { drawing, model } = await drawn(document);
    expect(wayOnGrid(drawing, model, "Root/A", { x: 9, y: 50 })).toEqual({ x: 8, y: 52 });
    const moved = mover(drawing, ["Root/A"])({ x: 3, y: 0.5 });
    expect(wayOnGrid(moved, model, "Root/A", { x: 0, y: 0 })).toEqual({ x: 1, y: -0.5 });
  });
  it("keep the level as it is drawn, and take its places away", async () => {
    const { drawing, model } = await drawn(document);
    expect(after(keepLayout(drawing, model, "Root")).fields["layout"]).toMatchObject({ a: { x: 0, y: 0 }, b: { x: 200, y: 0 } });
    expect(after(layOutAnew(document, model, "Root")).fields["layout"]).toEqual({ other: { x: 1, y: 1 } });
    expect(layOutAnew(document, model, "Root/A")).toHaveProperty("reason");
  });
  it("give the place of a point in a state that is open, and none in one that is not", async () => {
    const { drawing } = await drawn(document);
    const b = drawing.nodes.find(({ path }) => path === "Root/B") ?? expect.fail();
    expect(placeOf(drawing, b, { path: "Root", id: "r" })).toEqual({ x: 200, y: 0, side: "EAST", parent: "r" });
    expect(placeOf(drawing, b, { path: "Root/A", id: "a" })).toBeUndefined();
  });
});

describe("writeNote", () => {
  it("writes, changes and takes away; the same text is no edit", () => {
    expect(notesOf(after(writeNote(document, "b", "one\ntwo")))).toEqual({ a: "first", b: "one\ntwo" });
    expect(notesOf(after(writeNote(document, "a", " ")))).toEqual({});
    expect(writeNote(document, "a", "first")).toHaveProperty("reason");
  });
});

describe("mover", () => {
  it("moves a node with its ports, and lines to and from it still end there", async () => {
    const { drawing } = await drawn(document);
    const moved = mover(drawing, ["Root/B"])({ x: 40, y: 120 });
    const [before, now] = [drawing, moved].map(({ nodes }) => nodes.find(({ path }) => path === "Root/B") ?? expect.fail());
    expect(now).toMatchObject({ x: (before?.x ?? 0) + 40, y: (before?.y ?? 0) + 120 });
    expect(moved.lines.find(({ kind }) => kind === "transition")?.points.at(-1)?.x).toBe(now?.x);
    expect(moved.nodes.filter(({ path }) => path !== "Root/B")).toEqual(drawing.nodes.filter(({ path }) => path !== "Root/B"));
  });
});
