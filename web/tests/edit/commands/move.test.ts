import { describe, expect, it } from "vitest";
import { setFirst } from "../../../shared/edit/commands/first";
import { moveBeside, moveInOrder, moveInto, moveOut } from "../../../shared/edit/commands/move";
import { after, childrenOf, document, field, reasonOf, withFields } from "./fixture";

describe("moving into another state", () => {
  it("takes out what led to it from where it was, and the other way round", () => {
    const tree = after(moveInto(document, ["b"], "c"));
    expect(childrenOf(tree, "c")).toEqual(["D", "E", "B"]);
    expect([field(tree, "a-done", "to"), field(tree, "b-done", "to")]).toEqual([undefined, undefined]);
  });
  it("keeps what leads from one to another that moves with it; the first of them stays the first", () => {
    const unlinked = withFields("l", { state: "L" });
    const tree = after(moveInto(unlinked, ["b", "a"], "l"), unlinked);
    expect(childrenOf(tree, "l")).toEqual(["A", "B"]);
    expect(field(tree, "a-done", "to")).toBe("B");
    expect(field(tree, "l", "first")).toBe("A");
    expect(field(tree, "root", "first")).toBeUndefined();
  });
  it("gives it another name where its own is taken", () => {
    const taken = withFields("e", { state: "B" });
    const tree = after(moveInto(taken, ["b"], "c"), taken);
    expect(childrenOf(tree, "c")).toEqual(["D", "B", "B2"]);
  });
  it("does not move into itself, into a link, or to where it is", () => {
    expect(reasonOf(moveInto(document, ["c"], "d"))).toBe("a state does not move into itself");
    expect(reasonOf(moveInto(document, ["a"], "l"))).toContain("library state");
    expect(reasonOf(moveInto(document, ["d"], "c"))).toBe("it is there already");
    expect(reasonOf(moveInto(document, ["a-done"], "c"))).toContain("only states and barriers");
  });
});

describe("moving out", () => {
  it("puts it behind the state that it was in", () => {
    const tree = after(moveOut(document, ["e"]));
    expect(childrenOf(tree, "root")).toEqual(["A", "B", "C", "E", "Both", "L"]);
    expect(field(tree, "d-done", "to")).toBeUndefined();
  });
  it("does not leave the root", () => expect(reasonOf(moveOut(document, ["a"]))).toBe("there is no state around this one"));
});

describe("moving beside another one", () => {
  it("changes the order, of several as they stand", () => {
    expect(childrenOf(after(moveBeside(document, ["a"], "c", "behind")), "root")).toEqual(["B", "C", "A", "Both", "L"]);
    expect(childrenOf(after(moveBeside(document, ["c", "b"], "a", "before")), "root")).toEqual(["B", "C", "A", "Both", "L"]);
  });
  it("brings it into the state of that one", () => {
    const tree = after(moveBeside(document, ["b"], "e", "before"));
    expect(childrenOf(tree, "c")).toEqual(["D", "B", "E"]);
    expect(field(tree, "a-done", "to")).toBeUndefined();
  });
  it("does nothing where it is, beside the root, and inside of itself", () => {
    expect(reasonOf(moveBeside(document, ["a"], "b", "before"))).toBe("it is there already");
    expect(reasonOf(moveBeside(document, ["b"], "b", "behind"))).toBe("it is there already");
    expect(reasonOf(moveBeside(document, ["a"], "root", "behind"))).toBe("it has no siblings");
    expect(reasonOf(moveBeside(document, ["c"], "d", "behind"))).toBe("a state does not move into itself");
  });
});

describe("the order of evaluation", () => {
  it("changes one place at a time, up to the ends", () => {
    expect(childrenOf(after(moveInOrder(document, "b", "earlier")), "root")).toEqual(["B", "A", "C", "Both", "L"]);
    expect(childrenOf(after(moveInOrder(document, "b", "later")), "root")).toEqual(["A", "C", "B", "Both", "L"]);
    expect(reasonOf(moveInOrder(document, "a", "earlier"))).toBe("it is the first");
    expect(reasonOf(moveInOrder(document, "l", "later"))).toBe("it is the last");
  });
});

describe("where a composite begins", () => {
  it("is one of its states", () => {
    expect(field(after(setFirst(document, "b")), "root", "first")).toBe("B");
    expect(reasonOf(setFirst(document, "a"))).toBe("Root begins here already");
    expect(reasonOf(setFirst(document, "root"))).toContain("a state begins at a state");
  });
  it("is one of its barriers, as where states begin side by side", () => {
    expect(field(after(setFirst(document, "both")), "root", "first")).toBe("Both");
  });
});
