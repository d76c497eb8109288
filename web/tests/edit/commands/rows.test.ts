import { describe, expect, it } from "vitest";
import { addRow, moveRow, removeRow } from "../../../shared/edit/commands/rows";
import { apply } from "../../../shared/edit/apply";
import { plain } from "../../../shared/edit/exact";
import { Refusal } from "../../../shared/edit/refusal";
import type { Operation } from "../../../shared/edit/apply";
import type { Change } from "../../../shared/edit/session";
import { elementOf, listOf, type Tree } from "../../../shared/edit/tree";
import { treeOf } from "../documents";

const id = (name: string) => ({ meta: { id: name } });
const tree = treeOf({
  rcm: 1,
  library: [{ state: "Grasp", ...id("grasp"), ports: [{ name: "held", when: "True", ...id("held") }, { name: "lost", when: "False", ...id("lost") }] }],
  root: {
    state: "Root", ...id("root"),
    children: [
      { state: "A", ...id("a"), ports: [{ name: "success", when: "True", ...id("s") }, { name: "error", when: "True", ...id("e") }] },
      { state: "L", ...id("l"), link: "Grasp", ports: [{ name: "held", ...id("l-held") }] },
    ],
  },
});
const newId = () => "new";

function after(change: Change | undefined): Tree {
  const result = apply(tree, { operations: change !== undefined && "operations" in change ? plain<readonly Operation[]>(change.operations) : [] });
  if (result instanceof Refusal) throw result;
  return result.tree;
}

/** What addRow makes. */
function added(...row: Parameters<typeof addRow>): Tree {
  const made = addRow(...row);
  return after("change" in made ? made.change : undefined);
}

describe("a new row", () => {
  it("stands behind the one that it was made from, has a free name, and does nothing yet", () => {
    const now = added(tree, "a", "ports", "s", newId);
    expect(listOf(now, "a", "ports")).toEqual(["s", "new", "e"]);
    expect(elementOf(now, "new").fields).toMatchObject({ name: "success2", when: "False" });
  });
  it("of a link is what the library has and the link has not, yet", () => {
    expect(elementOf(added(tree, "l", "ports", "l-held", newId), "new").fields).toEqual({ name: "lost", meta: { id: "new" } });
  });
  it("is the first one of an empty list", () => expect(listOf(added(tree, "a", "actions", undefined, newId), "a", "actions")).toEqual(["new"]));
});

describe("a row", () => {
  it("is moved to a position, and not moved to its own", () => {
    expect(listOf(after(moveRow(tree, "e", 0)), "a", "ports")).toEqual(["e", "s"]);
    expect(listOf(after(moveRow(tree, "s", 9)), "a", "ports")).toEqual(["e", "s"]);
    expect(moveRow(tree, "s", 0)).toBeUndefined();
  });
  it("is removed", () => expect(listOf(after(removeRow("s")), "a", "ports")).toEqual(["e"]));
});
