// A document as its edits see it (core/edit/tree.h): every element by its id. An immutable value; of two trees that follow each other,
// what is the same in both is the same object, so that a page can compare by identity.
import type { Document } from "../../generated/messages";
import { entryOf, isObject, type JsonObject, type JsonValue } from "../json";
import { constant, description, readFields, type FieldReader } from "./fields";
import { readNode, writeElement, type ElementKind, type ElementNode, type ListName, type Lists } from "./element";
import { attempt, Refusal } from "./refusal";

export interface Element {
  readonly id: string;
  /** The state that has it; empty: the document. */
  readonly parent: string;
  /** Of its parent; nothing: the root. */
  readonly list: ListName | undefined;
  readonly kind: ElementKind;
  /** As the format has them, without the lists of a state. */
  readonly fields: JsonObject;
  /** Ids. */
  readonly lists: Lists<string>;
}

export interface Tree {
  /** Of the document: `name`, `services`, `layout`, `meta`; those that say something. */
  readonly fields: JsonObject;
  readonly root: string;
  readonly library: readonly string[];
  readonly elements: ReadonlyMap<string, Element>;
}

const kNoIds: readonly string[] = [];

/** An element without what is in its lists. */
export function elementOf(tree: Tree, id: string): Element {
  const element = tree.elements.get(id);
  if (element === undefined) throw new Error(`there is no element ${id}`);
  return element;
}

/** The elements of a list, in order; empty if there is no such state. */
export function listOf(tree: Tree, parent: string, list: ListName): readonly string[] {
  if (parent === "") return list === "library" ? tree.library : kNoIds;
  return tree.elements.get(parent)?.lists[list] ?? kNoIds;
}

/** Whether `id` is `ancestor` or below it. */
export function isBelow(tree: Tree, ancestor: string, id: string): boolean {
  for (let at = tree.elements.get(id); at !== undefined; at = tree.elements.get(at.parent)) if (at.id === ancestor) return true;
  return false;
}

/** `id` and all below it. Requires an element. */
export function subtree(tree: Tree, id: string): readonly string[] {
  return [id, ...Object.values(elementOf(tree, id).lists).flatMap((list) => list.flatMap((inner) => subtree(tree, inner)))];
}

/** Takes `node` apart, parents first. Throws Refusal (`missing`) if one of its elements has no id. */
export function flatten(node: ElementNode, parent: string, list: ListName | undefined): readonly Element[] {
  const { kind, id, fields } = node;
  if (id === "") throw new Refusal("missing", `a ${kind} has no \`meta.id\``);
  const lists: Record<string, readonly string[]> = {};
  const inner = Object.entries(node.lists).flatMap(([name, nodes]) => {
    lists[name] = nodes.map((each) => each.id);
    return nodes.flatMap((each) => flatten(each, id, name as ListName));
  });
  return [{ id, parent, list, kind, fields, lists }, ...inner];
}

/** Throws Refusal (`duplicate`) if `elements` has the id of one of `added`. */
export function addAll(elements: Map<string, Element>, added: readonly Element[]): void {
  for (const element of added) {
    if (elements.has(element.id)) throw new Refusal("duplicate", `an element has the id \`${element.id}\` already`);
    elements.set(element.id, element);
  }
}

/** What an object of entries is without any: nothing. */
export const orNothing = (entries: JsonObject): JsonObject | undefined => (Object.keys(entries).length === 0 ? undefined : entries);

const isTextObject = (value: JsonValue): value is JsonObject => isObject(value) && Object.values(value).every((item) => typeof item === "string");

const services: FieldReader = (value) => {
  if (value === undefined) return undefined;
  if (isTextObject(value)) return orNothing(value);
  throw new Refusal("type", "`services` must be an object of strings");
};

const layout: FieldReader = (value, field) => {
  const found = constant(value, field) ?? undefined;
  if (found === undefined || isObject(found)) return found && orNothing(found);
  throw new Refusal("type", "`layout` must be an object");
};

const documentMeta: FieldReader = (value, field) => {
  const found = constant(value, field) ?? undefined;
  if (!isObject(found)) return found;
  const { notes, ...rest } = found;
  if (notes !== undefined && !isTextObject(notes)) throw new Refusal("type", "`meta.notes` must be an object of texts, each by an id");
  return orNothing(notes === undefined || Object.keys(notes).length === 0 ? rest : found);
};

const version: FieldReader = (value) => {
  if (value !== 1) throw new Refusal("version", "`rcm` must be 1");
  return undefined;
};

const ignored: FieldReader = () => undefined;
const kDocument = { rcm: version, name: description, services, library: ignored, root: ignored, layout, meta: documentMeta };

/** Requires elements that all have ids, each another one; the server's documents are such. */
export function readTree(document: JsonValue): Tree | Refusal {
  return attempt(() => {
    if (!isObject(document)) throw new Refusal("type", "a document must be an object");
    const fields = readFields(document, kDocument);
    const root = entryOf(document, "root");
    const library = entryOf(document, "library") ?? [];
    if (root === undefined) throw new Refusal("missing", "the field `root` is missing");
    if (!Array.isArray(library)) throw new Refusal("type", "`library` must be a list");
    const rootNode = readNode(root, "children");
    if (rootNode.kind !== "state") throw new Refusal("type", "the root must be a state");
    const states = library.map((state: JsonValue) => readNode(state, "library"));
    const elements = new Map<string, Element>();
    addAll(elements, flatten(rootNode, "", undefined));
    for (const state of states) addAll(elements, flatten(state, "", "library"));
    return { fields, root: rootNode.id, library: states.map((state) => state.id), elements };
  });
}

interface Written {
  readonly inner: readonly JsonObject[];
  readonly json: JsonObject;
}
/** What was written of an element is the same as long as the element and what is in it are. */
const written = new WeakMap<Element, Written>();

/** `id` with all below it, as the format has it. Requires an element. */
export function writeNode(tree: Tree, id: string): JsonObject {
  const element = elementOf(tree, id);
  const lists = Object.entries(element.lists).map(([list, ids]) => [list, ids.map((inner) => writeNode(tree, inner))] as const);
  const inner = lists.flatMap(([, nodes]) => nodes);
  const before = written.get(element);
  if (before?.inner.length === inner.length && before.inner.every((node, i) => node === inner[i])) return before.json;
  const json = writeElement(element.kind, element.fields, Object.fromEntries(lists));
  written.set(element, { inner, json });
  return json;
}

/** The document, as its format has it: what did not change is the object that it was in the document before. */
export function documentOf(tree: Tree): Document {
  const { name, services: types, layout: places, meta: about } = tree.fields;
  const all = {
    rcm: 1, name, services: types, library: tree.library.length === 0 ? undefined : tree.library.map((id) => writeNode(tree, id)),
    root: writeNode(tree, tree.root), layout: places, meta: about,
  };
  // Every field was read with the type that the format gives it.
  return Object.fromEntries(Object.entries(all).filter(([, value]) => value !== undefined)) as unknown as Document;
}
