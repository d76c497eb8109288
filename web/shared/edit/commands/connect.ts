// Where ports and barriers lead to.
import type { Operation } from "../apply";
import { elementOf, listOf, type Tree } from "../tree";
import { addState } from "./add";
import { nameOfElement, type Command, type NewId } from "./command";
import { targetNames } from "./references";

/** The state of a port; a barrier itself. */
const ownerOf = (tree: Tree, from: string): string => (elementOf(tree, from).kind === "port" ? elementOf(tree, from).parent : from);

/** Why a port or barrier cannot lead to `to`; nothing: it can. */
export function reasonAgainstTarget(tree: Tree, from: string, to: string): string | undefined {
  const [source, target] = [tree.elements.get(from), tree.elements.get(to)];
  if (source === undefined || target === undefined) return "it is not there any more";
  if (source.kind !== "port" && source.kind !== "barrier") return "a port or a barrier leads to a state";
  if (target.list !== "children" || target.parent !== elementOf(tree, ownerOf(tree, from)).parent)
    return source.kind === "port" ? "a port leads to a sibling of its state" : "a barrier leads to sibling states";
  if (source.kind === "barrier" && target.kind !== "state") return "a barrier leads to states only";
  if (source.kind === "barrier" && targetNames(tree, from).includes(nameOfElement(tree, to))) return "it leads there already";
  return undefined;
}

/** All siblings that a port or barrier may lead to. */
export function targetsOf(tree: Tree, from: string): readonly string[] {
  const owner = ownerOf(tree, from);
  return listOf(tree, elementOf(tree, owner).parent, "children").filter((sibling) => reasonAgainstTarget(tree, from, sibling) === undefined);
}

/** Lets a port lead to a sibling, or a barrier to one more. */
export function connect(tree: Tree, from: string, to: string): Command {
  const reason = reasonAgainstTarget(tree, from, to);
  return reason === undefined ? { change: { compound: { kind: "connect", from, to } } } : { reason };
}

/** Lets a port lead nowhere, or a barrier no longer to `to`. */
export function disconnect(tree: Tree, from: string, to?: string): Command {
  const { kind } = elementOf(tree, from);
  if (kind === "barrier") return to === undefined ? { reason: "a barrier is told from which state" } : { change: { compound: { kind: "disconnect", barrier: from, state: to } } };
  if (targetNames(tree, from).length === 0) return { reason: "it leads nowhere" };
  return { change: { compound: { kind: "connect", from } } };
}

/** A new state to which a port or barrier leads, behind the state that it comes from. */
export function addTarget(tree: Tree, from: string, newId: NewId): Command {
  const owner = elementOf(tree, ownerOf(tree, from));
  if (owner.list !== "children") return { reason: "what it is in has no siblings" };
  const id = newId();
  const added = addState(tree, { parent: owner.parent, after: owner.id }, () => id);
  if ("reason" in added || !("operations" in added.change)) return added;
  const [insert] = added.change.operations;
  const name = insert?.op === "insert" ? insert.node["state"] : undefined;
  if (typeof name !== "string") return added;
  const value = elementOf(tree, from).kind === "barrier" ? [...targetNames(tree, from), name] : name;
  const lead: Operation = { op: "set", id: from, field: "to", value };
  return { change: { operations: [...added.change.operations, lead] }, select: id };
}
