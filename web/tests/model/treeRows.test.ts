import { describe, expect, it } from "vitest";
import type { State } from "../../shared/model/model";
import { buildTree } from "../../shared/model/modelTree";
import { rowByName, rowsBetween, treeMove, treeRows } from "../../shared/model/treeRows";

const state = (name: string, children: readonly State[] = []): State => ({ kind: "state", name, parameters: [], results: [], variables: [], actions: [], children, ports: [] });

const tree = buildTree(state("Task", [state("Pick", [state("Grasp"), state("Go")]), state("Place", [state("Put")]), state("Go")]));
const open = treeRows(tree, new Set());
const paths = (rows: ReturnType<typeof treeRows>) => rows.map(({ entry }) => entry.path);

describe("treeRows", () => {
  it("lists what is unfolded, each with its place among its siblings", () => {
    expect(paths(open)).toEqual([...tree.keys()]);
    expect(open.map(({ position, siblings }) => `${position}/${siblings}`)).toEqual(["1/1", "1/3", "1/2", "2/2", "2/3", "1/1", "3/3"]);
    expect(paths(treeRows(tree, new Set(["Task/Pick"])))).toEqual(["Task", "Task/Pick", "Task/Place", "Task/Place/Put", "Task/Go"]);
    expect(treeRows(tree, new Set(["Task/Pick"]))[1]?.open).toBe(false);
  });
});

describe("treeMove", () => {
  const folded = treeRows(tree, new Set(["Task/Place"]));
  it("goes up and down, and to both ends, and stays there", () => {
    expect(treeMove(open, 0, "ArrowDown", 10)).toEqual({ to: 1 });
    expect(treeMove(open, 0, "ArrowUp", 10)).toEqual({ to: 0 });
    expect(treeMove(open, 1, "End", 10)).toEqual({ to: 6 });
    expect(treeMove(open, 6, "ArrowDown", 10)).toEqual({ to: 6 });
    expect(treeMove(open, 6, "PageUp", 4)).toEqual({ to: 2 });
  });

  it("unfolds to the right before it goes into a state, and folds to the left before it leaves one", () => {
    expect(treeMove(open, 1, "ArrowRight", 10)).toEqual({ to: 2 });
    expect(treeMove(folded, 4, "ArrowRight", 10)).toEqual({ toggle: "Task/Place" });
    expect(treeMove(open, 1, "ArrowLeft", 10)).toEqual({ toggle: "Task/Pick" });
    expect(treeMove(open, 3, "ArrowLeft", 10)).toEqual({ to: 1 });
    expect(treeMove(open, 3, "x", 10)).toBeUndefined();
  });
});

describe("rowByName", () => {
  it("finds the next name that begins so, around the end", () => {
    expect(rowByName(open, 0, "g")).toBe(2);
    expect(rowByName(open, 2, "g")).toBe(3);
    expect(rowByName(open, 6, "g")).toBe(2);
    expect(rowByName(open, 2, "gr")).toBe(2);
    expect(rowByName(open, 0, "z")).toBeUndefined();
  });
});

describe("rowsBetween", () => {
  it("is what is in view and a few more, and never more than there are", () => {
    expect(rowsBetween(2000, 26, 2600, 3120)).toEqual({ first: 98, end: 122 });
    expect(rowsBetween(5, 26, 0, 500)).toEqual({ first: 0, end: 5 });
    expect(rowsBetween(5, 26, -900, -200)).toEqual({ first: 0, end: 0 });
    expect(rowsBetween(5, 26, 900, 1400)).toEqual({ first: 5, end: 5 });
  });
});
