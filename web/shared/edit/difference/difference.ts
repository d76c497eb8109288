// What has become of a document: the elements of two trees, compared by their ids.
import { entryOf, isObject, type JsonObject, type JsonValue } from "../../json";
import { elementOf, subtree, type Element, type Tree } from "../tree";
import { reordered } from "./order";
import { isSame } from "./same";

/** A field that is not the same; nothing: one of the two has none. */
export interface FieldChange {
  readonly field: string;
  /** Of a field whose entries are told one by one (`meta`, `layout`, `services`, `notes`): the entry. */
  readonly key?: string;
  readonly before: JsonValue | undefined;
  readonly after: JsonValue | undefined;
}

export interface ElementChange {
  readonly id: string;
  readonly fields: readonly FieldChange[];
}

/** Elements by their ids, parents before what is in them, in the order of the tree that has them. */
export interface Difference {
  /** Only the later tree has them; also what is in another one that was added. */
  readonly added: readonly string[];
  /** Only the earlier tree has them. */
  readonly removed: readonly string[];
  /** Both have them, in another state or list, or in another order among those that stayed: of these, as few as possible. */
  readonly moved: readonly string[];
  /** Both have them, with other fields. */
  readonly changed: readonly ElementChange[];
  /** Of the document itself. */
  readonly document: readonly FieldChange[];
}

const kNothing: JsonObject = {};
const kEntries: ReadonlySet<string> = new Set(["meta", "layout", "services", "notes"]);

function entryChanges(field: string, before: JsonObject, after: JsonObject): readonly FieldChange[] {
  const keys = new Set([...Object.keys(before), ...Object.keys(after)]);
  return [...keys].flatMap((key) => {
    const [old, now] = [entryOf(before, key), entryOf(after, key)];
    if (isSame(old, now)) return [];
    if (field === "meta" && key === "notes") return entryChanges("notes", isObject(old) ? old : kNothing, isObject(now) ? now : kNothing);
    return [{ field, key, before: old, after: now }];
  });
}

export function fieldChanges(before: JsonObject, after: JsonObject): readonly FieldChange[] {
  if (before === after) return [];
  const fields = new Set([...Object.keys(before), ...Object.keys(after)]);
  return [...fields].flatMap((field) => {
    const [old, now] = [entryOf(before, field), entryOf(after, field)];
    const hasEntries = kEntries.has(field) && (old === undefined || isObject(old)) && (now === undefined || isObject(now));
    if (hasEntries) return entryChanges(field, old ?? kNothing, now ?? kNothing);
    return isSame(old, now) ? [] : [{ field, before: old, after: now }];
  });
}

/** Pairs of elements that were found to have the same fields: trees that are compared again share most. */
const same = new WeakMap<Element, Element>();

function changesOf(before: Element, after: Element): readonly FieldChange[] {
  if (before === after || same.get(before) === after) return [];
  const changes = fieldChanges(before.fields, after.fields);
  if (changes.length === 0) same.set(before, after);
  return changes;
}

/** All elements, in the order of the document. */
export const allOf = (tree: Tree): readonly string[] => [tree.root, ...tree.library].flatMap((id) => subtree(tree, id));

/** A list of elements as one name: that of its parent and its own. */
const listName = ({ parent, list }: Element): string => `${parent}/${list ?? ""}`;

/** The lists of a tree with the ids in them; the root is in one by itself. */
function listsOf(tree: Tree, all: readonly string[]): ReadonlyMap<string, readonly string[]> {
  const lists = new Map<string, string[]>();
  for (const id of all) {
    const name = listName(elementOf(tree, id));
    const known = lists.get(name);
    if (known === undefined) lists.set(name, [id]);
    else known.push(id);
  }
  return lists;
}

function movedIn(before: Tree, old: readonly string[], after: Tree, now: readonly string[]): readonly string[] {
  const [oldLists, nowLists] = [listsOf(before, old), listsOf(after, now)];
  const within = new Set([...nowLists].flatMap(([name, ids]) => reordered(oldLists.get(name) ?? [], ids)));
  return now.filter((id) => {
    const was = before.elements.get(id);
    return was !== undefined && (within.has(id) || listName(was) !== listName(elementOf(after, id)));
  });
}

export function difference(before: Tree, after: Tree): Difference {
  const [old, now] = [allOf(before), allOf(after)];
  const changed = now.flatMap((id): ElementChange[] => {
    const was = before.elements.get(id);
    const fields = was === undefined ? [] : changesOf(was, elementOf(after, id));
    return fields.length === 0 ? [] : [{ id, fields }];
  });
  return {
    added: now.filter((id) => !before.elements.has(id)),
    removed: old.filter((id) => !after.elements.has(id)),
    moved: movedIn(before, old, after, now),
    changed,
    document: fieldChanges(before.fields, after.fields),
  };
}

/** Those of these elements of `tree` that are in no other one of them. */
export function outermostOf(tree: Tree, ids: readonly string[]): readonly string[] {
  const all = new Set(ids);
  return ids.filter((id) => !all.has(elementOf(tree, id).parent));
}
