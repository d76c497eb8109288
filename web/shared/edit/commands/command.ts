// What commands give, and what they share.
import type { ElementKind } from "../element";
import type { Change } from "../session";
import { elementOf, listOf, type Tree } from "../tree";
import { entryOf } from "../../json";

/** A change; `select`: the id of the element to select when it is there. Or why there is none. */
export type Command = { readonly change: Change; readonly select?: string } | { readonly reason: string };

/** Makes ids of new elements (shared/newId.ts): 1 to 64 of A-Z a-z 0-9 _ -, each time others. */
export type NewId = () => string;

const kNameFields: Readonly<Partial<Record<ElementKind, string>>> = { state: "state", barrier: "barrier" };

/** The name of an element; empty: it has none. */
export function nameOfElement(tree: Tree, id: string): string {
  const { kind, fields } = elementOf(tree, id);
  const name = entryOf(fields, kNameFields[kind] ?? "name");
  return typeof name === "string" ? name : "";
}

/** `wish`, or with the first number from 2 on that makes it a name that no element of `ids` has. */
export function freeName(tree: Tree, ids: readonly string[], wish: string): string {
  const names = new Set(ids.map((id) => nameOfElement(tree, id)));
  let name = wish;
  for (let i = 2; names.has(name); ++i) name = `${wish}${i}`;
  return name;
}

/** Names of the children of a state, of its results, and so on: `freeName` among the elements of a list. */
export const freeNameIn = (tree: Tree, parent: string, list: Parameters<typeof listOf>[2], wish: string): string => freeName(tree, listOf(tree, parent, list), wish);
