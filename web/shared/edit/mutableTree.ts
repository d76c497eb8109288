// A tree while an edit is applied to it: the four operations, one at a time (core/edit/tree.cpp). It shares all that it does not change
// with the tree that it was made of. Each operation returns the one that takes it back, or throws Refusal with the field as path.
import type { EditInsert, EditMove, EditRemove, EditSet } from "../../generated/messages";
import type { JsonObject, JsonValue } from "../json";
import { isStateList, readNode, type ListName } from "./element";
import { addAll, elementOf, flatten, isBelow, listOf, subtree, writeNode, type Element, type Tree } from "./tree";
import { attempt, Refusal } from "./refusal";
import { setDocumentField, setElementField, setMetaEntry } from "./setting";

/** Levels of lists and objects in the text of a document (core/value/json.h). */
const kMaxLevels = 64;

type Place = Pick<EditMove, "parent" | "list" | "after">;

function isDeeper(value: JsonValue, levels: number): boolean {
  if (typeof value !== "object" || value === null) return false;
  return levels === 0 || Object.values(value).some((item) => isDeeper(item, levels - 1));
}

/** The level of JSON at which an element of this list stands in the text. */
function levelOf(tree: Tree, parent: string, list: ListName | undefined): number {
  if (parent === "") return list === undefined ? 2 : 3;
  const state = elementOf(tree, parent);
  return levelOf(tree, state.parent, state.list) + 2;
}

function checkLevel(value: JsonValue, level: number, path: string): void {
  if (level > kMaxLevels || isDeeper(value, kMaxLevels + 1 - level))
    throw new Refusal("too_deep", `the text of the document would have more than ${kMaxLevels} levels of lists and objects`, path);
}

export class MutableTree implements Tree {
  fields: JsonObject;
  library: readonly string[];
  readonly root: string;
  readonly elements: Map<string, Element>;

  constructor(tree: Tree) {
    this.fields = tree.fields;
    this.library = tree.library;
    this.root = tree.root;
    this.elements = new Map(tree.elements);
  }

  insert(insert: EditInsert): EditRemove {
    const { parent, list, node } = insert;
    const at = this.position(insert, "");
    checkLevel(node, levelOf(this, parent, list), "node");
    const added = attempt(() => {
      const read = readNode(node, list);
      addAll(this.elements, flatten(read, parent, list));
      return read.id;
    });
    if (added instanceof Refusal) throw added.at("node");
    this.setList(parent, list, (ids) => [...ids.slice(0, at), added, ...ids.slice(at)]);
    return { op: "remove", id: added };
  }

  remove({ id }: EditRemove): EditInsert {
    const { parent, list } = this.listed(id, "a document has a root");
    const inverse: EditInsert = { op: "insert", parent, list, ...this.before(id, parent, list), node: writeNode(this, id) };
    for (const inner of subtree(this, id)) this.elements.delete(inner);
    this.setList(parent, list, (ids) => ids.filter((each) => each !== id));
    return inverse;
  }

  move(move: EditMove): EditMove {
    const { id, parent, list } = move;
    const element = this.listed(id, "the root cannot be moved");
    this.position(move, id);
    if (isBelow(this, id, parent)) throw new Refusal("not_accepted", `\`${id}\` cannot be moved into itself`, "parent");
    const wasNode = element.list === "children" || element.list === "library";
    const toNode = list === "children" || (list === "library" && element.kind === "state");
    if (wasNode ? !toNode : list !== element.list) throw new Refusal("type", `is no element of the list \`${list}\``, "list");
    const level = levelOf(this, parent, list);
    if (level > levelOf(this, element.parent, element.list)) checkLevel(writeNode(this, id), level, "parent");
    const inverse: EditMove = { op: "move", id, parent: element.parent, list: element.list, ...this.before(id, element.parent, element.list) };
    this.setList(element.parent, element.list, (ids) => ids.filter((each) => each !== id));
    const at = this.position(move, id);
    this.setList(parent, list, (ids) => [...ids.slice(0, at), id, ...ids.slice(at)]);
    this.elements.set(id, { ...elementOf(this, id), parent, list });
    return inverse;
  }

  set(set: EditSet): EditSet {
    const { id, field, key } = set;
    const old = id === "" ? this.setDocument(set) : this.setElement(set);
    return { op: "set", id, field, ...(key !== undefined && { key }), ...(old !== undefined && { value: old }) };
  }

  private setDocument(set: EditSet): JsonValue | undefined {
    const { fields, old } = setDocumentField(this.fields, set, (value) => checkLevel(value, 3, "value"));
    this.fields = fields;
    return old;
  }

  private setElement(set: EditSet): JsonValue | undefined {
    const element = this.elements.get(set.id);
    if (element === undefined) throw this.none(set.id, "id");
    const level = levelOf(this, element.parent, element.list);
    const { fields, old } =
      set.field === "meta"
        ? setMetaEntry(element, set, (value) => checkLevel(value, level + 2, "value"))
        : setElementField(element, set, (value) => checkLevel(value, level + 1, "value"));
    this.elements.set(set.id, { ...element, fields });
    return old;
  }

  private none(id: string, path: string): Refusal {
    return new Refusal("not_found", `there is no element \`${id}\``, path);
  }

  private listed(id: string, ofRoot: string): Element & { readonly list: ListName } {
    const element = this.elements.get(id);
    if (element === undefined) throw this.none(id, "id");
    const { list } = element;
    if (list === undefined) throw new Refusal("not_accepted", ofRoot, "id");
    return { ...element, list };
  }

  /** Where in the list a place is. */
  private position({ parent, list, after }: Place, moved: string): number {
    if ((parent === "") !== (list === "library")) throw new Refusal("type", "`library` is the list of the document, the others are lists of states", "list");
    if (parent !== "") {
      const state = this.elements.get(parent);
      if (state === undefined) throw this.none(parent, "parent");
      if (state.kind !== "state") throw new Refusal("type", `\`${parent}\` is no state: it has no lists`, "parent");
    }
    if (after === undefined) return 0;
    const at = listOf(this, parent, list).indexOf(after);
    if (at === -1 || after === moved) throw new Refusal("not_found", `there is no element \`${after}\` in this list`, "after");
    return at + 1;
  }

  /** The one before `id` in its list, if there is one. */
  private before(id: string, parent: string, list: ListName): { readonly after?: string } {
    const siblings = listOf(this, parent, list);
    const after = siblings[siblings.indexOf(id) - 1];
    return after === undefined ? {} : { after };
  }

  private setList(parent: string, list: ListName, change: (ids: readonly string[]) => readonly string[]): void {
    const ids = change(listOf(this, parent, list));
    if (parent === "") {
      this.library = ids;
    } else if (isStateList(list)) {
      const state = elementOf(this, parent);
      this.elements.set(parent, { ...state, lists: { ...state.lists, [list]: ids } });
    }
  }
}
