// What the server makes of several elements, or of one: groups, copies, and states of the library.
import { elementOf, type Tree } from "../tree";
import { freeNameIn, nameOfElement, type Command } from "./command";
import { outermost } from "./references";
import { reasonAgainstName } from "./rename";

/** Why these cannot become a group; nothing: the server decides. */
export function reasonAgainstGroup(tree: Tree, ids: readonly string[]): string | undefined {
  const all = outermost(tree, ids);
  if (all.length === 0) return "nothing is selected";
  if (all.some((id) => elementOf(tree, id).list !== "children")) return "a group is made of states and barriers inside of a state";
  return new Set(all.map((id) => elementOf(tree, id).parent)).size > 1 ? "a group is made of siblings" : undefined;
}

/** A free name for a group of these. */
export function nameForGroup(tree: Tree, [first]: readonly string[]): string {
  return first === undefined ? "Group" : freeNameIn(tree, elementOf(tree, first).parent, "children", "Group");
}

/** Puts siblings into a new state. */
export function group(tree: Tree, ids: readonly string[], name: string): Command {
  const reason = reasonAgainstGroup(tree, ids) ?? reasonAgainstName(name);
  return reason === undefined ? { change: { compound: { kind: "group", ids: outermost(tree, ids), name } } } : { reason };
}

/** Takes the children of a state out of it. */
export function ungroup(tree: Tree, id: string): Command {
  const { kind, list, lists } = elementOf(tree, id);
  if (kind !== "state" || (lists.children ?? []).length === 0) return { reason: "it has no states inside" };
  if (list !== "children") return { reason: "it is in no other state" };
  return { change: { compound: { kind: "ungroup", id } } };
}

/** A name in the library for a state. */
export const nameInLibrary = (tree: Tree, id: string): string => freeNameIn(tree, "", "library", nameOfElement(tree, id));

/** Moves a state to the library; a link stands in its place. */
export function extract(tree: Tree, id: string, name: string): Command {
  const { kind, list, fields } = elementOf(tree, id);
  if (kind !== "state" || list !== "children") return { reason: "what goes to the library is a state inside of another" };
  if (fields["link"] !== undefined) return { reason: "it is a link already" };
  const reason = reasonAgainstName(name);
  return reason === undefined ? { change: { compound: { kind: "extract", id, name } } } : { reason };
}

/** A copy behind the element, under a free name. */
export function duplicate(tree: Tree, id: string): Command {
  if (elementOf(tree, id).list === undefined) return { reason: "a document has one root" };
  return { change: { compound: { kind: "duplicate", id } } };
}
