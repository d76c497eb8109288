// Where a composite begins.
import { elementOf, type Tree } from "../tree";
import { nameOfElement, type Command } from "./command";

/** Lets the parent of a state or barrier begin there. */
export function setFirst(tree: Tree, id: string): Command {
  const { list, parent } = elementOf(tree, id);
  if (list !== "children") return { reason: "a state begins at a state or barrier inside of it" };
  const name = nameOfElement(tree, id);
  if (elementOf(tree, parent).fields["first"] === name) return { reason: `${nameOfElement(tree, parent)} begins here already` };
  return { change: { operations: [{ op: "set", id: parent, field: "first", value: name }] } };
}
