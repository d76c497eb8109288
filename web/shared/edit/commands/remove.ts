// Deleting elements.
import type { Operation } from "../apply";
import { withoutCommentsOn } from "../comments/write";
import { elementOf, type Tree } from "../tree";
import { nameOfElement, type Command } from "./command";
import { outermost, separate } from "./references";

/** The states that link a state of the library. */
export function linksTo(tree: Tree, libraryState: string): readonly string[] {
  const name = nameOfElement(tree, libraryState);
  return [...tree.elements.values()].filter((element) => element.kind === "state" && element.fields["link"] === name).map(({ id }) => id);
}

function reasonToKeep(tree: Tree, id: string): string | undefined {
  const { list } = elementOf(tree, id);
  if (list === undefined) return "a document has a root";
  const links = list === "library" ? linksTo(tree, id) : [];
  const [first, ...more] = links.map((link) => nameOfElement(tree, link));
  return first === undefined ? undefined : `it is linked by ${first}${more.length > 0 ? ` and ${more.length} more` : ""}`;
}

/** Deletes elements with all in them, what leads to them (targets of ports and barriers, and `first`), and the comments on them. Code that names them stays. */
export function remove(tree: Tree, ids: readonly string[]): Command {
  const gone = outermost(tree, ids);
  if (gone.length === 0) return { reason: "nothing is selected" };
  const reason = gone.map((id) => reasonToKeep(tree, id)).find((each) => each !== undefined);
  if (reason !== undefined) return { reason };
  const children = gone.filter((id) => elementOf(tree, id).list === "children");
  const parents = new Set(children.map((id) => elementOf(tree, id).parent));
  const leaving = new Set(children);
  const inLeaving = (operation: Operation) => operation.op === "set" && (leaving.has(operation.id) || leaving.has(elementOf(tree, operation.id).parent));
  const cut = [...parents].flatMap((parent) => separate(tree, parent, leaving)).filter((operation) => !inLeaving(operation));
  return { change: { operations: [...cut, ...withoutCommentsOn(tree, gone), ...gone.map((id): Operation => ({ op: "remove", id }))] } };
}
