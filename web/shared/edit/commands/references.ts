// By which names the elements of a composite lead to each other: `to` of ports and barriers, and `first`.
import type { Operation } from "../apply";
import { elementOf, listOf, type Tree } from "../tree";
import { entryOf, type JsonValue } from "../../json";
import { nameOfElement } from "./command";

/** The names in `to` of a port or barrier. */
export function targetNames(tree: Tree, id: string): readonly string[] {
  const to = entryOf(elementOf(tree, id).fields, "to");
  if (typeof to === "string") return [to];
  return Array.isArray(to) ? to.filter((name: JsonValue) => typeof name === "string") : [];
}

/** What leads somewhere among the children of `composite`: the ports of states, and barriers. */
const sourcesIn = (tree: Tree, composite: string): readonly string[] =>
  listOf(tree, composite, "children").flatMap((child) => (elementOf(tree, child).kind === "barrier" ? [child] : listOf(tree, child, "ports")));

function withoutNames(tree: Tree, source: string, names: ReadonlySet<string>): readonly Operation[] {
  const all = targetNames(tree, source);
  const kept = all.filter((name) => !names.has(name));
  if (kept.length === all.length) return [];
  return [elementOf(tree, source).kind === "barrier" ? { op: "set", id: source, field: "to", value: kept } : { op: "set", id: source, field: "to" }];
}

/**
 * Takes out what leads from the children of `composite` that stay to those that leave it, and the other way round. A name that one of either
 * side has, too (siblings of a draft may have the same), stays: it may mean that one.
 */
export function separate(tree: Tree, composite: string, leaving: ReadonlySet<string>): readonly Operation[] {
  const children = listOf(tree, composite, "children");
  const names = (isWanted: (id: string) => boolean) => new Set(children.filter(isWanted).map((id) => nameOfElement(tree, id)));
  const [gone, left] = [names((id) => leaving.has(id)), names((id) => !leaving.has(id))];
  const only = (some: ReadonlySet<string>, others: ReadonlySet<string>) => new Set([...some].filter((name) => !others.has(name)));
  const [onlyGone, onlyLeft] = [only(gone, left), only(left, gone)];
  const isLeaving = (source: string) => leaving.has(source) || leaving.has(elementOf(tree, source).parent);
  const cut = sourcesIn(tree, composite).flatMap((source) => withoutNames(tree, source, isLeaving(source) ? onlyLeft : onlyGone));
  const first = entryOf(elementOf(tree, composite).fields, "first");
  return typeof first === "string" && onlyGone.has(first) ? [...cut, { op: "set", id: composite, field: "first" }] : cut;
}

/** The ids that are not below another one of them, in the order of the document. */
export function outermost(tree: Tree, ids: readonly string[]): readonly string[] {
  const chosen = new Set(ids);
  const within = (id: string): readonly string[] => (chosen.has(id) ? [id] : Object.values(elementOf(tree, id).lists).flatMap((list) => list.flatMap(within)));
  return [tree.root, ...tree.library].flatMap(within);
}
