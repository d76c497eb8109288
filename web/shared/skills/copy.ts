// Copies a library state, with all that it links, into the library of another document: numbers as they were written, ids new.
import { nameOfElement, freeName, type NewId } from "../edit/commands/command";
import { isExactObject, itemsOf, type ExactObject } from "../edit/clipboard/json";
import { withNewIds } from "../edit/clipboard/paste";
import { plain, type Exact, type ExactJson } from "../edit/exact";
import type { Operation } from "../edit/apply";
import { listOf, writeNode, type Tree } from "../edit/tree";
import { isObject, type JsonValue } from "../json";
import { closureOf, declaredServices, servicesOf, serviceText } from "./closure";

/** A document that has skills: `exact` is the same document as `tree`, with its numbers as the server has written them. */
export interface SkillDocument {
  readonly name: string;
  readonly tree: Tree;
  readonly exact: ExactJson;
}

/** As a text: what a state is, whoever it is. Keys in one order, elements without ids, the state without its name. */
function contentOf(state: JsonValue): string {
  const write = (value: JsonValue): JsonValue => {
    if (Array.isArray(value)) return value.map(write);
    if (!isObject(value)) return value;
    const entries = Object.entries(value).filter(([key]) => key !== "meta").map(([key, item]) => [key, write(item)] as const);
    const meta = value["meta"];
    const marks = meta !== undefined && isObject(meta) ? Object.entries(meta).filter(([key]) => key !== "id") : [];
    const all = marks.length > 0 ? [...entries, ["meta", Object.fromEntries(marks.sort(([a], [b]) => (a < b ? -1 : 1)))] as const] : entries;
    return Object.fromEntries([...all].sort(([a], [b]) => (a < b ? -1 : 1)));
  };
  return JSON.stringify(write(isObject(state) ? { ...state, state: "" } : state));
}

/** The state with other names in its links, and in those of its children. */
function relinked(state: ExactObject, names: ReadonlyMap<string, string>): ExactObject {
  const link = state["link"];
  const children = itemsOf(state["children"]).map((child) => (isExactObject(child) ? relinked(child, names) : child));
  return { ...state, ...(children.length > 0 && { children }), ...(typeof link === "string" && { link: names.get(link) ?? link }) };
}

export type Copied = { readonly operations: readonly Exact<Operation>[]; readonly link: string } | { readonly reason: string };

/** What adds a service to those of the document, if it is not there yet; or why it cannot be there. */
export function addService(target: Tree, key: string, type: string): readonly Operation[] | string {
  const own = declaredServices(target)[key];
  if (own === undefined) return [{ op: "set", id: "", field: "services", key, value: type }];
  return own === type ? [] : `${serviceText(key)} is another one here: \`${own}\`, not \`${type}\``;
}

/** The same for the services that a state needs. */
function addServices(target: Tree, { tree }: SkillDocument, id: string): readonly Operation[] | string {
  const types = declaredServices(tree);
  const operations: Operation[] = [];
  for (const key of servicesOf(tree, id)) {
    const type = types[key];
    const added = type === undefined ? [] : addService(target, key, type);
    if (typeof added === "string") return added;
    operations.push(...added);
  }
  return operations;
}

/** Which name the state has in the library of `target`, and what brings it there. A state that is there already is not copied again. */
export function copyState(target: Tree, source: SkillDocument, id: string, newId: NewId): Copied {
  const services = addServices(target, source, id);
  if (typeof services === "string") return { reason: services };
  const exact = new Map<string, ExactObject>();
  const document = source.exact;
  for (const state of isExactObject(document) ? itemsOf(document["library"]).filter(isExactObject) : []) if (typeof state["state"] === "string") exact.set(state["state"], state);
  const known = new Map(target.library.map((state) => [nameOfElement(target, state), contentOf(writeNode(target, state))]));
  const names = new Map<string, string>();
  const inserts: Exact<Operation>[] = [];
  let after = listOf(target, "", "library").at(-1);
  for (const state of closureOf(source.tree, id)) {
    const name = nameOfElement(source.tree, state);
    const written = exact.get(name);
    if (written === undefined) return { reason: `the document ${source.name} has changed meanwhile` };
    const copy = relinked(written, names);
    const content = contentOf(plain<JsonValue>(copy));
    const equal = known.get(name) === content ? name : [...known].find(([, each]) => each === content)?.[0];
    if (equal !== undefined) {
      names.set(name, equal);
      continue;
    }
    const free = freeNameAmong(target, known, name);
    const node = withNewIds({ ...copy, state: free }, newId, new Map());
    inserts.push({ op: "insert", parent: "", list: "library", ...(after !== undefined && { after }), node });
    after = (node["meta"] as { readonly id: string }).id;
    known.set(free, content);
    names.set(name, free);
  }
  return { operations: [...services, ...inserts], link: names.get(nameOfElement(source.tree, id)) ?? "" };
}

function freeNameAmong(target: Tree, known: ReadonlyMap<string, string>, wish: string): string {
  let name = freeName(target, target.library, wish);
  for (let i = 2; known.has(name); ++i) name = `${wish}${i}`;
  return name;
}
