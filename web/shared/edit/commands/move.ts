// Moving states and barriers to another composite, and in the order of evaluation.
import type { Operation } from "../apply";
import { elementOf, isBelow, listOf, type Tree } from "../tree";
import { freeName, nameOfElement, type Command } from "./command";
import { placeIn, type PlaceOrReason } from "./place";
import { outermost, separate } from "./references";

function reasonAgainst(tree: Tree, ids: readonly string[], parent: string): string | undefined {
  if (ids.length === 0) return "nothing is selected";
  if (ids.some((id) => elementOf(tree, id).list !== "children")) return "only states and barriers inside of a state move";
  if (ids.some((id) => isBelow(tree, id, parent))) return "a state does not move into itself";
  return undefined;
}

/** The names that they have where they move to: another one if one of the same name stands there. */
function namesIn(tree: Tree, ids: readonly string[], parent: string): ReadonlyMap<string, string> {
  const others = listOf(tree, parent, "children").filter((id) => !ids.includes(id));
  return new Map(ids.map((id) => [id, freeName(tree, others, nameOfElement(tree, id))]));
}

function renames(tree: Tree, names: ReadonlyMap<string, string>): readonly Operation[] {
  const renamed = [...names].filter(([id, name]) => nameOfElement(tree, id) !== name);
  return renamed.map(([id, value]) => ({ op: "set", id, field: elementOf(tree, id).kind === "barrier" ? "barrier" : "state", value }));
}

/** A composite that had no state begins at the first that comes: at the one that was first where it was, if that comes. */
function firstOf(tree: Tree, names: ReadonlyMap<string, string>, parent: string): readonly Operation[] {
  const isState = (id: string) => elementOf(tree, id).kind === "state";
  if (listOf(tree, parent, "children").some(isState)) return [];
  const isFirst = (id: string) => elementOf(tree, elementOf(tree, id).parent).fields["first"] === nameOfElement(tree, id);
  const states = [...names].filter(([id]) => isState(id));
  const [, value] = states.find(([id]) => isFirst(id)) ?? states[0] ?? [];
  return value === undefined ? [] : [{ op: "set", id: parent, field: "first", value }];
}

function moveTo(tree: Tree, selected: readonly string[], place: PlaceOrReason): Command {
  if ("reason" in place) return place;
  const { parent } = place;
  const ids = outermost(tree, selected);
  const reason = reasonAgainst(tree, ids, parent);
  if (reason !== undefined) return { reason };
  const names = namesIn(tree, ids, parent);
  const named = renames(tree, names);
  // What they lead to each other by is their names.
  if (named.length > 0 && ids.length > 1) return { reason: "there is one of the same name already: rename it, or move them one by one" };
  const from = new Set(ids.map((id) => elementOf(tree, id).parent).filter((each) => each !== parent));
  const cut = [...from].flatMap((each) => separate(tree, each, new Set(ids)));
  const moves = ids.map((id, i): Operation => {
    const after = i === 0 ? place.after : ids[i - 1];
    return { op: "move", id, parent, list: "children", ...(after !== undefined && { after }) };
  });
  return { change: { operations: [...cut, ...named, ...moves, ...firstOf(tree, names, parent)] } };
}

/** Why these do not move into the state `parent`; whether names stand in the way is known when they do. */
export function reasonAgainstMovingInto(tree: Tree, ids: readonly string[], parent: string): string | undefined {
  if (ids.every((id) => tree.elements.get(id)?.parent === parent)) return "it is there already";
  const place = placeIn(tree, parent);
  return "reason" in place ? place.reason : reasonAgainst(tree, ids, parent);
}

/** Moves states and barriers into the state `parent`, behind what is there. What led to them from where they were is taken out, and the other way round. */
export function moveInto(tree: Tree, ids: readonly string[], parent: string): Command {
  if (ids.every((id) => tree.elements.get(id)?.parent === parent)) return { reason: "it is there already" };
  return moveTo(tree, ids, placeIn(tree, parent));
}

/** Moves states and barriers before or behind `beside`, into the state that it is in: in order, or from elsewhere. */
export function moveBeside(tree: Tree, selected: readonly string[], beside: string, side: "before" | "behind"): Command {
  const { parent, list } = elementOf(tree, beside);
  if (list !== "children") return { reason: "it has no siblings" };
  const ids = outermost(tree, selected);
  const siblings = listOf(tree, parent, "children");
  const others = siblings.filter((id) => !ids.includes(id));
  const before = siblings.slice(0, siblings.indexOf(beside) + (side === "before" ? 0 : 1)).filter((id) => !ids.includes(id));
  const after = before.at(-1);
  const order = [...before, ...ids, ...others.slice(before.length)];
  if (order.length === siblings.length && order.every((id, i) => id === siblings[i])) return { reason: "it is there already" };
  return moveTo(tree, ids, { parent, ...(after !== undefined && { after }) });
}

/** Moves states and barriers out of their state, to behind it. */
export function moveOut(tree: Tree, ids: readonly string[]): Command {
  const all = outermost(tree, ids);
  const [parent, ...more] = new Set(all.map((id) => elementOf(tree, id).parent));
  if (parent === undefined || parent === "" || more.length > 0) return { reason: "only what is in one state moves out of it" };
  const { list, parent: above } = elementOf(tree, parent);
  if (list !== "children") return { reason: "there is no state around this one" };
  return moveTo(tree, all, { parent: above, after: parent });
}

/** Moves an element one place earlier or later among its siblings: the order in which they are evaluated. */
export function moveInOrder(tree: Tree, id: string, by: "earlier" | "later"): Command {
  const { parent, list } = elementOf(tree, id);
  if (list === undefined) return { reason: "the root has no siblings" };
  const siblings = listOf(tree, parent, list);
  const place = siblings.indexOf(id);
  if (by === "earlier" ? place === 0 : place === siblings.length - 1) return { reason: by === "earlier" ? "it is the first" : "it is the last" };
  const after = by === "earlier" ? siblings[place - 2] : siblings[place + 1];
  return { change: { operations: [{ op: "move", id, parent, list, ...(after !== undefined && { after }) }] } };
}
