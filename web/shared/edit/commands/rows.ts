// The lists of a state as rows: adding, removing and moving what stands in them.
import type { ExactJson } from "../exact";
import type { ListName } from "../element";
import type { Change } from "../session";
import { elementOf, listOf, type Tree } from "../tree";
import { entryOf } from "../../json";
import { freeName, nameOfElement, type Command, type NewId } from "./command";

export type RowList = Exclude<ListName, "children" | "library">;

/** What a new port is called first: what the states of the thesis have. */
const kNames: Readonly<Record<Exclude<RowList, "actions">, string>> = { parameters: "parameter", results: "result", variables: "variable", ports: "success" };

/** Names that the linked state declares in this list and this one does not, yet. */
function linkedNames(tree: Tree, parent: string, list: RowList): readonly string[] {
  const link = entryOf(elementOf(tree, parent).fields, "link");
  const linked = tree.library.find((id) => nameOfElement(tree, id) === link);
  if (link === undefined || linked === undefined) return [];
  const own = new Set(listOf(tree, parent, list).map((id) => nameOfElement(tree, id)));
  return listOf(tree, linked, list)
    .map((id) => nameOfElement(tree, id))
    .filter((name) => !own.has(name));
}

/** A new action, or port, does nothing before its condition is written. */
function newRow(tree: Tree, parent: string, list: RowList): Readonly<Record<string, ExactJson>> {
  if (list === "actions") return { when: "False", do: "pass" };
  const name = linkedNames(tree, parent, list)[0] ?? freeName(tree, listOf(tree, parent, list), kNames[list]);
  return { name, ...(list === "ports" && entryOf(elementOf(tree, parent).fields, "link") === undefined && { when: "False" }) };
}

/** A new row behind `after`, or as the first one. */
export function addRow(tree: Tree, parent: string, list: RowList, after: string | undefined, newId: NewId): Command & { readonly select: string } {
  const id = newId();
  const node = { ...newRow(tree, parent, list), meta: { id } };
  return { change: { operations: [{ op: "insert", parent, list, ...(after !== undefined && { after }), node }] }, select: id };
}

export const removeRow = (id: string): Change => ({ operations: [{ op: "remove", id }] });

/** The element at another position of its list; nothing if it stands there already. Requires an element of a list. */
export function moveRow(tree: Tree, id: string, to: number): Change | undefined {
  const { parent, list } = elementOf(tree, id);
  if (list === undefined) return undefined;
  const others = listOf(tree, parent, list).filter((each) => each !== id);
  const at = Math.max(0, Math.min(to, others.length));
  if (listOf(tree, parent, list).indexOf(id) === at) return undefined;
  const after = others[at - 1];
  return { operations: [{ op: "move", id, parent, list, ...(after !== undefined && { after }) }] };
}
