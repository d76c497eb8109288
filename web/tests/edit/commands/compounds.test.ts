import { describe, expect, it } from "vitest";
import { addTarget, connect, disconnect, reasonAgainstTarget, targetsOf } from "../../../shared/edit/commands/connect";
import { duplicate, extract, group, nameForGroup, nameInLibrary, ungroup } from "../../../shared/edit/commands/group";
import { rename, renameService } from "../../../shared/edit/commands/rename";
import { after, childrenOf, compoundOf, document, field, newIds, reasonOf } from "./fixture";

describe("connecting", () => {
  it("leads a port to a sibling, and a barrier to one more state", () => {
    expect(compoundOf(connect(document, "b-done", "a"))).toEqual({ kind: "connect", from: "b-done", to: "a" });
    expect(compoundOf(connect(document, "both", "b"))).toEqual({ kind: "connect", from: "both", to: "b" });
  });
  it("lists the targets that there are", () => {
    expect(targetsOf(document, "a-done")).toEqual(["a", "b", "c", "both", "l"]);
    expect(targetsOf(document, "both")).toEqual(["b", "l"]);
    expect(targetsOf(document, "d-done")).toEqual(["d", "e"]);
  });
  it("says why another one is none", () => {
    expect(reasonAgainstTarget(document, "a-done", "d")).toBe("a port leads to a sibling of its state");
    expect(reasonAgainstTarget(document, "both", "both")).toBe("a barrier leads to states only");
    expect(reasonAgainstTarget(document, "both", "c")).toBe("it leads there already");
  });
  it("makes the state to which it leads", () => {
    const tree = after(addTarget(document, "a-done", newIds()));
    expect(childrenOf(tree, "root")).toEqual(["A", "State", "B", "C", "Both", "L"]);
    expect(field(tree, "a-done", "to")).toBe("State");
    expect(field(after(addTarget(document, "both", newIds())), "both", "to")).toEqual(["C", "A", "State"]);
  });
  it("ends", () => {
    expect(compoundOf(disconnect(document, "a-done"))).toEqual({ kind: "connect", from: "a-done" });
    expect(compoundOf(disconnect(document, "both", "c"))).toEqual({ kind: "disconnect", barrier: "both", state: "c" });
    expect(reasonOf(disconnect(document, "pick-done"))).toBe("it leads nowhere");
  });
});

describe("what the server makes", () => {
  it("is a group of siblings, in their order", () => {
    expect(compoundOf(group(document, ["b", "a"], "Group"))).toEqual({ kind: "group", ids: ["a", "b"], name: "Group" });
    expect(nameForGroup(document, ["a"])).toBe("Group");
    expect(reasonOf(group(document, ["a", "d"], "Group"))).toBe("a group is made of siblings");
    expect(reasonOf(group(document, ["a", "b"], "my group"))).toContain("a name has letters");
  });
  it("is the inside of a composite", () => {
    expect(compoundOf(ungroup(document, "c"))).toEqual({ kind: "ungroup", id: "c" });
    expect(reasonOf(ungroup(document, "a"))).toBe("it has no states inside");
    expect(reasonOf(ungroup(document, "root"))).toBe("it is in no other state");
  });
  it("is a state of the library", () => {
    expect(compoundOf(extract(document, "c", "C"))).toEqual({ kind: "extract", id: "c", name: "C" });
    expect(nameInLibrary(document, "c")).toBe("C");
    expect(reasonOf(extract(document, "l", "L"))).toBe("it is a link already");
  });
  it("is a copy", () => {
    expect(compoundOf(duplicate(document, "a-done"))).toEqual({ kind: "duplicate", id: "a-done" });
    expect(reasonOf(duplicate(document, "root"))).toBe("a document has one root");
  });
});

describe("renaming", () => {
  it("names the element anew, wherever it is named", () => expect(compoundOf(rename(document, "a", "Approach"))).toEqual({ kind: "rename", id: "a", name: "Approach" }));
  it("gives a service another key", () => {
    expect(compoundOf(renameService("gripper", "hand"))).toEqual({ kind: "rename_service", key: "gripper", name: "hand" });
    expect(reasonOf(renameService("gripper", "the hand"))).toContain("a name has letters");
  });
  it("says why a name is none", () => {
    expect(reasonOf(rename(document, "a", "2nd"))).toContain("begins with no digit");
    expect(reasonOf(rename(document, "a", "B"))).toBe("there is a B already");
    expect(reasonOf(rename(document, "a", "A"))).toBe("that is its name");
  });
});
