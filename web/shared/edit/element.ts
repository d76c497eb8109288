// Elements: the nodes of the tree that a document is to its edits (core/edit/element.h), read and written one at a time.
import type { EditList } from "../../generated/messages";
import { entryOf, isObject, type JsonObject, type JsonValue } from "../json";
import { constant, description, type FieldReader, keep, meta, oracle, requiredText, requiredTexts, text, type } from "./fields";
import { Refusal } from "./refusal";

/** The lists of elements: `library` of the document, the others of a state. */
export type ListName = EditList;
export type ElementKind = "state" | "barrier" | "parameter" | "declaration" | "action" | "port";

/** Elements by the lists of a state that have some. */
export type Lists<T> = Readonly<Partial<Record<ListName, readonly T[]>>>;

/** An element with all below it, apart. */
export interface ElementNode {
  readonly kind: ElementKind;
  /** Empty: it has none. */
  readonly id: string;
  /** As the format has them, without the lists of a state. */
  readonly fields: JsonObject;
  readonly lists: Lists<ElementNode>;
}

type StateList = Exclude<ListName, "library">;
const kStateLists: ReadonlySet<string> = new Set<StateList>(["parameters", "results", "variables", "actions", "children", "ports"]);

export const isStateList = (name: string): name is StateList => kStateLists.has(name);
export const isList = (name: string): name is ListName => name === "library" || isStateList(name);

type Format = Readonly<Record<string, FieldReader | "elements">>;

/** Fields in the order of the format. */
const kFormats: Readonly<Record<ElementKind, Format>> = {
  state: {
    state: requiredText, doc: description, parameters: "elements", results: "elements", variables: "elements", entry: text, exit: text,
    actions: "elements", children: "elements", first: text, ports: "elements", keep, link: text, oracle, meta,
  },
  barrier: { barrier: requiredText, to: requiredTexts, meta },
  parameter: { name: requiredText, value: constant, from: text, type, unit: description, doc: description, meta },
  declaration: { name: requiredText, initial: constant, type, unit: description, doc: description, meta },
  action: { when: requiredText, do: requiredText, meta },
  port: { name: requiredText, when: text, after: text, to: text, meta },
};

function kindIn(json: JsonObject, list: ListName): ElementKind {
  switch (list) {
    case "parameters":
      return "parameter";
    case "results":
    case "variables":
      return "declaration";
    case "actions":
      return "action";
    case "ports":
      return "port";
    default:
      return Object.hasOwn(json, "barrier") && !Object.hasOwn(json, "state") ? "barrier" : "state";
  }
}

function readList(value: JsonValue | undefined, list: StateList): readonly ElementNode[] {
  if (value === undefined) return [];
  if (Array.isArray(value)) return value.map((item: JsonValue) => readNode(item, list));
  throw new Refusal("type", `\`${list}\` must be a list`);
}

/** An element as the format has it in `list`; the root: in `children`. Throws Refusal: the first of the errors that the server finds. */
export function readNode(json: JsonValue, list: ListName): ElementNode {
  if (!isObject(json)) throw new Refusal("type", "an element must be an object");
  const kind = kindIn(json, list);
  const fields: [string, JsonValue][] = [];
  const lists: [string, readonly ElementNode[]][] = [];
  for (const [field, reader] of Object.entries(kFormats[kind])) {
    const value = entryOf(json, field);
    if (reader !== "elements") {
      const kept = reader(value, field);
      if (kept !== undefined) fields.push([field, kept]);
    } else if (isStateList(field)) {
      const inner = readList(value, field);
      if (inner.length > 0) lists.push([field, inner]);
    }
  }
  const unknown = Object.keys(json).find((field) => !Object.hasOwn(kFormats[kind], field));
  if (unknown !== undefined) throw new Refusal("unknown_field", `there is no field \`${unknown}\` of a ${kind}`);
  if (list === "library" && kind !== "state") throw new Refusal("type", "is no element of the list `library`");
  const read: JsonObject = Object.fromEntries(fields);
  const about = read["meta"];
  const id = isObject(about) ? entryOf(about, "id") : undefined;
  return { kind, id: typeof id === "string" ? id : "", fields: read, lists: Object.fromEntries(lists) };
}

/** As the format has it; `inner`: what is in its lists. */
export function writeElement(kind: ElementKind, fields: JsonObject, inner: Lists<JsonObject>): JsonObject {
  const all = Object.keys(kFormats[kind]).map((field) => {
    const elements = isStateList(field) ? inner[field] : undefined;
    return [field, elements === undefined || elements.length === 0 ? entryOf(fields, field) : elements] as const;
  });
  return Object.fromEntries(all.filter((field): field is [string, JsonValue] => field[1] !== undefined));
}
