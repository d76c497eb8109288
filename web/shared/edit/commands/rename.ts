// Another name, also wherever the element is named.
import { elementOf, listOf, type Tree } from "../tree";
import { nameOfElement, type Command } from "./command";

const kName = /^[A-Za-z_][A-Za-z0-9_]*$/;

/** Why `name` is none; nothing: it is one. */
export const reasonAgainstName = (name: string): string | undefined =>
  kName.test(name) ? undefined : "a name has letters, digits and _, and begins with no digit";

export function rename(tree: Tree, id: string, name: string): Command {
  const element = tree.elements.get(id);
  if (element === undefined) return { reason: "it is not there any more" };
  if (element.kind === "action") return { reason: "an action has no name" };
  const reason = reasonAgainstName(name);
  if (reason !== undefined) return { reason };
  if (nameOfElement(tree, id) === name) return { reason: "that is its name" };
  const siblings = element.list === undefined ? [] : listOf(tree, element.parent, element.list);
  if (siblings.some((sibling) => nameOfElement(tree, sibling) === name)) return { reason: `there is a ${name} already` };
  return { change: { compound: { kind: "rename", id: elementOf(tree, id).id, name } } };
}

/** Another key for a service of the document, also wherever it is used. */
export function renameService(key: string, name: string): Command {
  const reason = reasonAgainstName(name);
  return reason === undefined ? { change: { compound: { kind: "rename_service", key, name } } } : { reason };
}
