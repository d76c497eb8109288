// Where the document names an element or service: what is renamed with it (core/edit/rename.cpp).
import { nameOfElement } from "../edit/commands/command";
import type { ListName } from "../edit/element";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf, isObject, type JsonValue } from "../json";
import { beginsWith, referencesIn } from "./references";
import { fromTexts, linkedBy, statesOf, textsInScope, type CodeText } from "./texts";
import type { Span } from "./tokens";
import { valueSpans } from "./values";

/** A place that names it: a target of a port or barrier, where a composite begins, what it keeps, a link, what a link redefines, or code. */
export type UsageKind = "target" | "first" | "keep" | "link" | "override" | "oracle" | "code" | "service";

export interface Usage {
  /** The element that has the field; empty: the document. */
  readonly id: string;
  readonly field: string;
  readonly kind: UsageKind;
  /** In a text of code: where the name stands. */
  readonly span?: Span;
}

const field = (tree: Tree, id: string, name: string): JsonValue | undefined => entryOf(tree.elements.get(id)?.fields, name);
const hasName = (value: JsonValue | undefined, name: string): boolean => Array.isArray(value) && value.includes(name);

const inTexts = (texts: readonly CodeText[], path: readonly string[]): readonly Usage[] =>
  texts.flatMap(({ id, field: of, text }) =>
    referencesIn(text).filter((reference) => beginsWith(reference, path)).map(({ spans }): Usage => ({ id, field: of, kind: "code", span: spans[path.length - 1] ?? { from: 0, to: 0 } })),
  );

/** The `from` that the children of a state have from the library, as they give the parameter nothing of their own. */
function takenOver(tree: Tree, state: string): readonly CodeText[] {
  return listOf(tree, state, "children").flatMap((child) => {
    const given = new Set<string>();
    const found: CodeText[] = [];
    for (let at: string | undefined = child, links = 0; at !== undefined && links <= tree.library.length; at = linkedBy(tree, at), ++links) {
      if (at !== child) found.push(...fromTexts(tree, at).filter(({ id }) => !given.has(nameOfElement(tree, id))));
      for (const id of listOf(tree, at, "parameters")) if (field(tree, id, "value") !== undefined || field(tree, id, "from") !== undefined) given.add(nameOfElement(tree, id));
    }
    return found;
  });
}

const inScope = (tree: Tree, state: string, path: readonly string[]): readonly Usage[] => inTexts([...textsInScope(tree, state), ...takenOver(tree, state)], path);

/** A child of a composite: targets, `first`, and code. */
function ofChild(tree: Tree, parent: string, name: string): readonly Usage[] {
  const targets = listOf(tree, parent, "children").flatMap((child): readonly Usage[] => {
    const ports = listOf(tree, child, "ports").filter((port) => field(tree, port, "to") === name);
    const isBarrierTo = hasName(field(tree, child, "to"), name);
    return [...ports, ...(isBarrierTo ? [child] : [])].map((id) => ({ id, field: "to", kind: "target" }));
  });
  const first: readonly Usage[] = field(tree, parent, "first") === name ? [{ id: parent, field: "first", kind: "first" }] : [];
  const oracle = field(tree, parent, "oracle");
  const expression = isObject(oracle) ? entryOf(oracle, "expr") : undefined;
  const chosen = typeof expression === "string" ? valueSpans(expression, name) : [];
  return [...targets, ...first, ...inScope(tree, parent, ["chi", name]), ...chosen.map((span): Usage => ({ id: parent, field: "oracle", kind: "oracle", span }))];
}

/** `state`, and all states whose links lead to it. */
function usersOf(tree: Tree, state: string): readonly string[] {
  return [state, ...statesOf(tree).filter((id) => id !== state && leadsTo(tree, id, state))];
}

function leadsTo(tree: Tree, id: string, state: string): boolean {
  for (let at = linkedBy(tree, id), links = 0; at !== undefined && links <= tree.library.length; at = linkedBy(tree, at), ++links) if (at === state) return true;
  return false;
}

/** A parameter, result or port of a state: in its code, in that of the parents of all that use the state, and where a link redefines it. */
function ofState(tree: Tree, state: string, collection: string, list: ListName, name: string): readonly Usage[] {
  const redefined = (user: string) => (user === state || list === "results" ? [] : listOf(tree, user, list).filter((id) => nameOfElement(tree, id) === name).slice(0, 1));
  const outside = usersOf(tree, state).flatMap((user): readonly Usage[] => {
    const { parent, list: place } = elementOf(tree, user);
    const seen = place === "children" ? inScope(tree, parent, ["chi", nameOfElement(tree, user), collection, name]) : [];
    return [...seen, ...redefined(user).map((id): Usage => ({ id, field: "name", kind: "override" }))];
  });
  return [...inScope(tree, state, [collection, name]), ...outside];
}

/** A port: what its state keeps or resumes, and the state that waits for its time. */
function ofPort(tree: Tree, state: string, port: string, name: string): readonly Usage[] {
  const [keep, oracle] = [field(tree, state, "keep"), field(tree, state, "oracle")];
  const kept = hasName(isObject(keep) ? entryOf(keep, "ports") : keep, name);
  const resumed = isObject(oracle) && hasName(entryOf(oracle, "resume"), name);
  return [
    ...(kept ? [{ id: state, field: "keep", kind: "keep" } as const] : []),
    ...(resumed ? [{ id: state, field: "oracle", kind: "keep" } as const] : []),
    ...(field(tree, port, "after") === undefined ? [] : inScope(tree, state, ["chi", `After_${name}`])),
    ...ofState(tree, state, "port", "ports", name),
  ];
}

/** Where the document names an element, besides the element itself. Of what a link redefines: where the library's is named. */
export function usagesOf(tree: Tree, id: string): readonly Usage[] {
  const element = tree.elements.get(id);
  if (element === undefined) return [];
  const [{ parent, list }, name] = [element, nameOfElement(tree, id)];
  switch (list) {
    case "children":
      return ofChild(tree, parent, name);
    case "library":
      return statesOf(tree).filter((state) => field(tree, state, "link") === name).map((state) => ({ id: state, field: "link", kind: "link" }));
    case "ports":
      return ofPort(tree, parent, id, name);
    case "parameters":
      return ofState(tree, parent, "par", list, name);
    case "results":
      return ofState(tree, parent, "res", list, name);
    case "variables":
      return usagesOfVariable(tree, parent, name);
    default:
      return [];
  }
}

/** Where a state and what is in it name a variable, which need not be declared. */
export const usagesOfVariable = (tree: Tree, state: string, name: string): readonly Usage[] => inScope(tree, state, ["var", name]);

/** Where the document names a service by its key; `member`: an operation or event of it. */
export function usagesOfService(tree: Tree, key: string, member?: string): readonly Usage[] {
  const services = entryOf(tree.fields, "services");
  const declared: readonly Usage[] = member === undefined && isObject(services) && entryOf(services, key) !== undefined ? [{ id: "", field: "services", kind: "service" }] : [];
  return [...declared, ...inTexts(statesOf(tree).flatMap((state) => textsInScope(tree, state)), member === undefined ? ["svc", key] : ["svc", key, member])];
}

