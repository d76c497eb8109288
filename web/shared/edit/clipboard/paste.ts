// A text of elements as an edit that adds them.
import type { Operation } from "../apply";
import { nameOfElement, type Command, type NewId } from "../commands/command";
import { placeAt, placeIn } from "../commands/place";
import { isStateList, readNode } from "../element";
import { plain, readExact, type Exact, type ExactJson } from "../exact";
import { attempt, Refusal } from "../refusal";
import { elementOf, listOf, type Tree } from "../tree";
import type { JsonValue } from "../../json";
import { isExactObject, itemsOf, type ExactObject } from "./json";
import { messageOf } from "../../messageOf";

type PastedList = "children" | "ports";
type Pasted = Readonly<Record<PastedList, readonly ExactObject[]>>;

/** What the text has in its lists; the path and code of an element that is none. */
function readPasted(text: string): Pasted | { readonly reason: string } {
  let value: ExactJson;
  try {
    value = readExact(text);
  } catch (error) {
    return { reason: `the text is no JSON (syntax): ${messageOf(error)}` };
  }
  if (!isExactObject(value)) return { reason: "the text has no states, barriers or ports (type)" };
  const whole: ExactObject = "state" in value || "barrier" in value ? { children: [value] } : "name" in value ? { ports: [value] } : value;
  const unknown = Object.keys(whole).find((key) => key !== "children" && key !== "ports");
  if (unknown !== undefined) return { reason: `${unknown}: the text has \`children\` and \`ports\` (unknown_field)` };
  for (const list of ["children", "ports"] as const) {
    for (const [i, item] of itemsOf(whole[list]).entries()) {
      const read = attempt(() => readNode(plain<JsonValue>(item), list));
      if (read instanceof Refusal) return { reason: `${list}/${i}${read.path === "" ? "" : `/${read.path}`}: ${read.message} (${read.code})` };
    }
  }
  const pasted = { children: itemsOf(whole["children"]).filter(isExactObject), ports: itemsOf(whole["ports"]).filter(isExactObject) };
  return pasted.children.length + pasted.ports.length === 0 ? { reason: "the text has no states, barriers or ports (missing)" } : pasted;
}

/** The element with new ids, and all in it; `copies`: notes the new id of each. */
export function withNewIds(element: ExactObject, newId: NewId, copies: Map<string, string>): ExactObject {
  const { meta } = element;
  const id = newId();
  if (isExactObject(meta) && typeof meta["id"] === "string") copies.set(meta["id"], id);
  const lists = Object.entries(element).filter(([key]) => isStateList(key));
  const inner = lists.map(([key, items]) => [key, itemsOf(items).filter(isExactObject).map((item) => withNewIds(item, newId, copies))] as const);
  return { ...element, ...Object.fromEntries(inner), meta: { ...(isExactObject(meta) ? meta : {}), id } };
}

const nameField = (element: ExactObject): string => ("state" in element ? "state" : "barrier" in element ? "barrier" : "name");
const nameIn = (element: ExactObject): string => {
  const name = element[nameField(element)];
  return typeof name === "string" ? name : "";
};

/** Free names for the elements of a list, by the names that they have. */
function freeNames(taken: readonly string[], elements: readonly ExactObject[]): ReadonlyMap<string, string> {
  const used = new Set(taken);
  const names = new Map<string, string>();
  for (const wish of elements.map(nameIn)) {
    let name = wish;
    for (let i = 2; used.has(name); ++i) name = `${wish}${i}`;
    used.add(name);
    if (!names.has(wish)) names.set(wish, name);
  }
  return names;
}

/** Texts in quotes are no names. */
const kChild = /'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*"|\bchi\.([A-Za-z_][A-Za-z0-9_]*)/g;
const renamedCode = (code: string, names: ReadonlyMap<string, string>): string =>
  code.replace(kChild, (found: string, name?: string) => (name === undefined ? found : `chi.${names.get(name) ?? name}`));

const mapField = (element: ExactObject, field: string, change: (text: string) => string): ExactObject => {
  const value = element[field];
  if (typeof value === "string") return { ...element, [field]: change(value) };
  return Array.isArray(value) ? { ...element, [field]: itemsOf(value).map((item) => (typeof item === "string" ? change(item) : item)) } : element;
};

/** The child under its new name; what it leads to, and takes from its siblings, under theirs. */
function renamed(element: ExactObject, names: ReadonlyMap<string, string>): ExactObject {
  const another = (name: string) => names.get(name) ?? name;
  const named = { ...element, [nameField(element)]: another(nameIn(element)) };
  if ("barrier" in named) return mapField(named, "to", another);
  const ports = itemsOf(named["ports"]).filter(isExactObject).map((port) => mapField(port, "to", another));
  const parameters = itemsOf(named["parameters"]).filter(isExactObject).map((parameter) => mapField(parameter, "from", (code) => renamedCode(code, names)));
  return { ...named, ...(ports.length > 0 && { ports }), ...(parameters.length > 0 && { parameters }) };
}

/** Inserts of the elements of a list, one behind the other. */
function inserts(parent: string, list: PastedList, first: string | undefined, elements: readonly ExactObject[]): readonly Exact<Operation>[] {
  let after = first;
  return elements.map((node) => {
    const operation = { op: "insert", parent, list, ...(after !== undefined && { after }), node } as const;
    after = (node["meta"] as { readonly id: string }).id;
    return operation;
  });
}

/** Adds what the text has: states and barriers where a new state would stand by what is selected (`at`), ports to that state. `copies`: gets the new ids by the old. */
export function paste(tree: Tree, at: string, text: string, newId: NewId, copies = new Map<string, string>()): Command {
  const pasted = readPasted(text);
  if ("reason" in pasted) return pasted;
  const focus = elementOf(tree, at);
  const place = focus.list === "children" ? placeAt(tree, at) : placeIn(tree, at);
  if (pasted.children.length > 0 && "reason" in place) return place;
  if (pasted.ports.length > 0 && focus.kind !== "state") return { reason: "only a state has ports" };
  const parent = "reason" in place ? at : place.parent;
  const namesOf = (owner: string, list: PastedList) => listOf(tree, owner, list).map((id) => nameOfElement(tree, id));
  const names = freeNames(namesOf(parent, "children"), pasted.children);
  const children = pasted.children.map((child) => withNewIds(renamed(child, names), newId, copies));
  const portNames = freeNames(namesOf(at, "ports"), pasted.ports);
  const ports = pasted.ports.map((port) => withNewIds({ ...port, name: portNames.get(nameIn(port)) ?? nameIn(port) }, newId, copies));
  const first = children.find((child) => "state" in child);
  const begins = first !== undefined && !listOf(tree, parent, "children").some((id) => elementOf(tree, id).kind === "state");
  const operations = [
    ...inserts(parent, "children", "reason" in place ? undefined : place.after, children),
    ...(begins ? [{ op: "set", id: parent, field: "first", value: nameIn(first) } as const] : []),
    ...inserts(at, "ports", listOf(tree, at, "ports").at(-1), ports),
  ];
  const one = [...children, ...ports][0]?.["meta"];
  return { change: { operations }, ...(isExactObject(one) && typeof one["id"] === "string" && { select: one["id"] }) };
}
