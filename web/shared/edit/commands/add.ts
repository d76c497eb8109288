// New states, barriers, links to library states, ports and library states.
import type { Operation } from "../apply";
import type { ExactObject } from "../clipboard/json";
import type { Exact } from "../exact";
import { elementOf, listOf, type Tree } from "../tree";
import { freeNameIn, nameOfElement, type Command, type NewId } from "./command";
import type { PlaceOrReason } from "./place";

const meta = (id: string): { readonly meta: { readonly id: string } } => ({ meta: { id } });

/** Adds the child `node` under the name `wish`, or one like it that is free; the first state of a composite becomes its `first`. */
export function addChild(tree: Tree, place: PlaceOrReason, id: string, wish: string, node: (name: string) => ExactObject, isState: boolean): Command {
  if ("reason" in place) return place;
  const { parent, after } = place;
  const name = freeNameIn(tree, parent, "children", wish);
  const insert: Exact<Operation> = { op: "insert", parent, list: "children", ...(after !== undefined && { after }), node: { ...node(name), ...meta(id) } };
  const isFirst = isState && !listOf(tree, parent, "children").some((child) => elementOf(tree, child).kind === "state");
  return { change: { operations: isFirst ? [insert, { op: "set", id: parent, field: "first", value: name }] : [insert] }, select: id };
}

/** Adds an empty state. */
export const addState = (tree: Tree, place: PlaceOrReason, newId: NewId, wish = "State"): Command => addChild(tree, place, newId(), wish, (state) => ({ state }), true);

/** Adds a barrier that leads nowhere yet. */
export const addBarrier = (tree: Tree, place: PlaceOrReason, newId: NewId, wish = "Barrier"): Command =>
  addChild(tree, place, newId(), wish, (barrier) => ({ barrier, to: [] }), false);

/** Whether the library state `id` is, or has inside, `state` or a link by which it would have itself inside. */
function wouldContain(tree: Tree, id: string, state: string): boolean {
  const seen = new Set<string>();
  const has = (at: string): boolean => {
    if (at === state) return true;
    if (seen.has(at)) return false;
    seen.add(at);
    const { fields, lists } = elementOf(tree, at);
    const linked = tree.library.find((each) => nameOfElement(tree, each) === fields["link"]);
    return (linked !== undefined && has(linked)) || (lists.children ?? []).some((child) => has(child));
  };
  return has(id);
}

/** Adds a state that links the library state `id`, with the ports of that: each can then be led somewhere. */
export function addLink(tree: Tree, place: PlaceOrReason, id: string, newId: NewId): Command {
  if (!tree.library.includes(id)) return { reason: "it is not in the library any more" };
  const link = nameOfElement(tree, id);
  if (!("reason" in place) && wouldContain(tree, id, place.parent)) return { reason: `${link} would contain itself` };
  const ports = listOf(tree, id, "ports").map((port) => ({ name: nameOfElement(tree, port), ...meta(newId()) }));
  return addChild(tree, place, newId(), link, (state) => ({ state, ...(ports.length > 0 && { ports }), link }), true);
}

/** Adds a port without a condition, which is still to be written. */
export function addPort(tree: Tree, state: string, newId: NewId, wish = "done"): Command {
  const element = tree.elements.get(state);
  if (element?.kind !== "state") return { reason: "only a state has ports" };
  if (element.fields["link"] !== undefined) return { reason: "a link has the ports of its library state" };
  const id = newId();
  const after = listOf(tree, state, "ports").at(-1);
  const node = { name: freeNameIn(tree, state, "ports", wish), ...meta(id) };
  return { change: { operations: [{ op: "insert", parent: state, list: "ports", ...(after !== undefined && { after }), node }] }, select: id };
}

/** Adds an empty state to the library. */
export function addLibraryState(tree: Tree, newId: NewId, wish = "Library"): Command {
  const id = newId();
  const after = tree.library.at(-1);
  const node = { state: freeNameIn(tree, "", "library", wish), ...meta(id) };
  return { change: { operations: [{ op: "insert", parent: "", list: "library", ...(after !== undefined && { after }), node }] }, select: id };
}
