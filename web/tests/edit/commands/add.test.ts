import { describe, expect, it } from "vitest";
import { addBarrier, addLibraryState, addLink, addPort, addState } from "../../../shared/edit/commands/add";
import { placeAt, placeIn } from "../../../shared/edit/commands/place";
import { listOf, writeNode } from "../../../shared/edit/tree";
import { after, childrenOf, document, field, newIds, reasonOf } from "./fixture";

describe("a new state", () => {
  it("stands inside of the selected composite, at its end, under a free name", () => {
    const tree = after(addState(document, placeAt(document, "c"), newIds(), "D"));
    expect(childrenOf(tree, "c")).toEqual(["D", "E", "D2"]);
    expect(field(tree, "c", "first")).toBe("D");
  });
  it("stands behind a selected state without children, or a barrier", () => {
    expect(childrenOf(after(addState(document, placeAt(document, "a"), newIds())), "root")).toEqual(["A", "State", "B", "C", "Both", "L"]);
    expect(childrenOf(after(addBarrier(document, placeAt(document, "both"), newIds())), "root")).toEqual(["A", "B", "C", "Both", "Barrier", "L"]);
  });
  it("is where its parent begins, if it is the first inside", () => {
    const tree = after(addState(document, placeIn(document, "a"), newIds()));
    expect(field(tree, "a", "first")).toBe("State");
    const barrier = after(addBarrier(document, placeIn(document, "a"), newIds()));
    expect(field(barrier, "a", "first")).toBeUndefined();
    expect(field(after(addState(barrier, placeIn(barrier, "a"), () => "n9"), barrier), "a", "first")).toBe("State");
  });
  it("does not stand in a link or a barrier", () => {
    expect(reasonOf(addState(document, placeIn(document, "l"), newIds()))).toContain("library state Pick");
    expect(reasonOf(addState(document, placeIn(document, "both"), newIds()))).toBe("only a state has states inside");
  });
});

describe("a link to a library state", () => {
  it("has the ports of that, to lead them somewhere", () => {
    const tree = after(addLink(document, placeAt(document, "a"), "pick", newIds()));
    const link = listOf(tree, "root", "children")[1] ?? "";
    expect(writeNode(tree, link)).toMatchObject({ state: "Pick", link: "Pick", ports: [{ name: "done" }, { name: "failed" }] });
  });
  it("does not stand inside of the library state itself, nor of one that it has inside", () => {
    expect(reasonOf(addLink(document, placeIn(document, "pick"), "pick", newIds()))).toBe("Pick would contain itself");
    const outer = after(addLibraryState(document, () => "outer", "Outer"));
    const linked = after(addLink(outer, placeIn(outer, "outer"), "pick", newIds()), outer);
    expect(reasonOf(addLink(linked, placeIn(linked, "pick"), "outer", newIds()))).toBe("Outer would contain itself");
  });
});

describe("a new port", () => {
  it("stands behind the others, and has no condition yet", () => {
    const tree = after(addPort(document, "a", newIds()));
    expect(listOf(tree, "a", "ports").map((port) => writeNode(tree, port)["name"])).toEqual(["done", "done2"]);
    expect(field(tree, "n1", "when")).toBeUndefined();
  });
  it("is not one of a barrier or a link", () => {
    expect(reasonOf(addPort(document, "both", newIds()))).toBe("only a state has ports");
    expect(reasonOf(addPort(document, "l", newIds()))).toContain("library state");
  });
});

describe("a new library state", () => {
  it("has a free name", () => expect(after(addLibraryState(document, newIds(), "Pick")).library.length).toBe(2));
});
