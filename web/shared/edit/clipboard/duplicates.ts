// Copies of several elements as one edit, which is undone as one. (The server makes a copy of one: `duplicate`.)
import type { Operation } from "../apply";
import type { Command, NewId } from "../commands/command";
import { outermost } from "../commands/references";
import type { Exact, ExactJson } from "../exact";
import { elementOf, listOf, type Tree } from "../tree";
import { copyText } from "./copy";
import { isExactObject, type ExactObject } from "./json";
import { paste } from "./paste";

/** The ids by the state that they are in, in the order of its children. */
function byParent(tree: Tree, ids: readonly string[]): readonly (readonly string[])[] {
  const parents = new Set(ids.map((id) => elementOf(tree, id).parent));
  return [...parents].map((parent) => listOf(tree, parent, "children").filter((id) => ids.includes(id)));
}

/** The copies of what is placed inside of what was copied are placed likewise. */
function places(layout: ExactObject, inner: readonly (readonly [id: string, copy: string])[]): readonly Exact<Operation>[] {
  return inner.flatMap(([id, copy]) => {
    const value = layout[id];
    return value === undefined ? [] : [{ op: "set", id: "", field: "layout", key: copy, value } as const];
  });
}

/** `made`: the ids of the copies. */
export type Duplicates = { readonly change: { readonly operations: readonly Exact<Operation>[] }; readonly made: readonly string[] } | { readonly reason: string };

/** Copies states and barriers, each group of siblings behind its last one. `document`: as the server stores it, numbers as they were written. */
export function duplicates(document: ExactJson, tree: Tree, ids: readonly string[], newId: NewId): Duplicates {
  const all = outermost(tree, ids);
  if (all.length === 0) return { reason: "they are not there any more" };
  const operations: Exact<Operation>[] = [];
  const copies = new Map<string, string>();
  for (const siblings of byParent(tree, all)) {
    const copied = copyText(document, tree, siblings);
    const [last] = siblings.slice(-1);
    if ("reason" in copied || last === undefined) return "reason" in copied ? copied : { reason: "only states and barriers inside of a state are copied together" };
    const command: Command = paste(tree, last, copied.text, newId, copies);
    if ("reason" in command) return command;
    if ("operations" in command.change) operations.push(...command.change.operations);
  }
  const layout = isExactObject(document) ? document["layout"] : undefined;
  const inner = [...copies].filter(([id]) => !all.includes(id));
  return { change: { operations: [...operations, ...(isExactObject(layout) ? places(layout, inner) : [])] }, made: all.flatMap((id) => copies.get(id) ?? []) };
}
