// The scope of a text of code: which names it may use (core/SEMANTICS.md, section 2), as the checker of core/rcm finds them.
import { nameOfElement } from "../edit/commands/command";
import type { ListName } from "../edit/element";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf, isObject } from "../json";
import { readType, valueName, type Name, type NameKind } from "./names";
import { referencesIn } from "./references";
import { serviceNames, type KnownService } from "./services";
import { behaviourOf, kindOf, linkedBy, textsInScope, type CodeFieldName, type CodeKind } from "./texts";
import { kAvailable, kBuiltins, kCollections, kModules, parametersText, type Collection, type LanguageFunction } from "./words";

export interface Scope {
  readonly kind: CodeKind;
  readonly names: readonly Name[];
}

/** A text of a document: the field of an element. */
export interface CodePlace {
  readonly id: string;
  readonly field: CodeFieldName;
}

const textOf = (tree: Tree, id: string, field: string): string | undefined => {
  const value = entryOf(elementOf(tree, id).fields, field);
  return typeof value === "string" ? value : undefined;
};

const declared = (tree: Tree, state: string | undefined, list: ListName, kind: NameKind): readonly Name[] =>
  state === undefined
    ? []
    : listOf(tree, state, list).map((id) =>
        valueName(nameOfElement(tree, id), kind, { type: readType(entryOf(elementOf(tree, id).fields, "type")), unit: textOf(tree, id, "unit"), doc: textOf(tree, id, "doc") }),
      );

const portNames = (tree: Tree, state: string | undefined): readonly Name[] =>
  state === undefined ? [] : listOf(tree, state, "ports").map((id) => ({ name: nameOfElement(tree, id), kind: "port", type: "bool", doc: textOf(tree, id, "when") ?? "Whether it is active." }));

const part = (name: Collection, doc: string, members: () => readonly Name[]): Name => ({ name, kind: "collection", doc, members });

/** What a parent sees of a child: a state as its library state has it. */
function childName(tree: Tree, id: string): Name {
  const own: readonly Name[] = [
    { name: "active", kind: "active", type: "bool", doc: "Whether the child is active." },
    { name: "name", kind: "constant", type: "string", doc: "The name of the child." },
  ];
  const name = nameOfElement(tree, id);
  if (elementOf(tree, id).kind === "barrier") return { name, kind: "child", doc: "A barrier.", members: () => own };
  const behaviour = behaviourOf(tree, id);
  const doc = textOf(tree, id, "doc") ?? (behaviour === undefined ? undefined : textOf(tree, behaviour, "doc"));
  const members = () => [
    part("par", "Its parameters.", () => declared(tree, behaviour, "parameters", "parameter")),
    part("res", "Its results.", () => declared(tree, behaviour, "results", "result")),
    part("port", "Its ports: whether they are active.", () => portNames(tree, behaviour)),
    ...own,
  ];
  return { name, kind: "child", members, ...(doc !== undefined && { doc }) };
}

/** Children that the translation makes: of ports with a time-out, and of an oracle. */
function madeChildren(tree: Tree, state: string): readonly Name[] {
  const timed = listOf(tree, state, "ports").filter((port) => textOf(tree, port, "after") !== undefined);
  const made = [...timed.map((port) => `After_${nameOfElement(tree, port)}`), ...(timed.length > 0 ? ["After"] : []), ...(oracleKind(tree, state) === undefined ? [] : ["Dispatcher"])];
  return made.map((name) => ({ name, kind: "child", doc: "Made when the document is translated.", isOpen: true }));
}

function oracleKind(tree: Tree, state: string): string | undefined {
  const oracle = entryOf(elementOf(tree, state).fields, "oracle");
  const kind = isObject(oracle) ? entryOf(oracle, "kind") : undefined;
  return typeof kind === "string" ? kind : undefined;
}

/** Variables need no declaration: those that the texts of the state use are known, too. */
function variableNames(tree: Tree, state: string): readonly Name[] {
  const known = declared(tree, state, "variables", "variable");
  const used = textsInScope(tree, state).flatMap(({ text }) => referencesIn(text).flatMap(({ names: [root, name] }) => (root === "var" && name !== undefined ? [name] : [])));
  const others = [...new Set(used)].filter((name) => !known.some((each) => each.name === name));
  return [...known, ...others.map((name): Name => ({ name, kind: "variable", doc: "Not declared: it has no value until it is written.", isOpen: true }))];
}

const functionName = ({ name, parameters, doc }: LanguageFunction): Name => ({ name, kind: "function", doc, call: parametersText(parameters) });

const moduleNames: readonly Name[] = Object.entries(kModules).map(([name, { doc, functions, constants }]) => ({
  name, kind: "module", doc, members: () => [...functions.map(functionName), ...constants.map((constant): Name => ({ name: constant, kind: "constant", type: "number" }))],
}));

/** The names of the language itself, with no state. */
export const languageNames: readonly Name[] = [...kBuiltins.map(functionName), functionName(kAvailable), ...moduleNames];

/** The state whose names the text uses; nothing: it is not known here, as each link has its own. */
export function stateOf(tree: Tree, { id, field }: CodePlace): string | undefined {
  const element = elementOf(tree, id);
  if (element.kind === "state") return id;
  if (field !== "from") return element.parent;
  const owner = elementOf(tree, element.parent);
  return owner.parent === "" ? undefined : owner.parent;
}

function collections(tree: Tree, state: string, kind: CodeKind, services: readonly KnownService[]): readonly Name[] {
  const behaviour = linkedBy(tree, state) === undefined ? state : (behaviourOf(tree, state) ?? state);
  const collection = (name: Collection, members: () => readonly Name[], more: Partial<Name> = {}): Name => ({ name, kind: "collection", doc: kCollections[name], members, ...more });
  const everywhere = [
    collection("par", () => declared(tree, behaviour, "parameters", "parameter")),
    collection("res", () => declared(tree, behaviour, "results", "result")),
    collection("var", () => variableNames(tree, state), { isOpen: true }),
    collection("chi", () => [...listOf(tree, state, "children").map((child) => childName(tree, child)), ...madeChildren(tree, state)]),
  ];
  if (kind === "expression") return everywhere;
  return [...everywhere, collection("port", () => portNames(tree, behaviour)), collection("svc", () => serviceNames(tree, services), services.length === 0 ? { isOpen: true } : {})];
}

const open = (name: Collection): Name => ({ name, kind: "collection", doc: kCollections[name], isOpen: true });

/** The kind of the text at a place: an oracle has an expression, or a call of a service. */
const kindAt = (tree: Tree, { id, field }: CodePlace): CodeKind => (field === "oracle" && oracleKind(tree, id) === "expr" ? "expression" : kindOf(field));

/** The names for the text at `place`, which is one of the document. */
export function scopeOf(tree: Tree, place: CodePlace, services: readonly KnownService[]): Scope {
  const kind = kindAt(tree, place);
  const state = stateOf(tree, place);
  const own = state === undefined ? (["par", "res", "var", "chi"] as const).map(open) : collections(tree, state, kind, services);
  return { kind, names: [...own, ...languageNames] };
}

/** The names for the condition of a breakpoint at an element, or of the whole task (`id` undefined). Without the document, or of what it does not
 *  have, those of any state. */
export function conditionScope(tree: Tree | undefined, id: string | undefined, services: readonly KnownService[]): Scope {
  const at = id ?? tree?.root;
  if (tree === undefined || at === undefined || !tree.elements.has(at)) return { kind: "condition", names: [...(["par", "res", "var", "chi", "port", "svc"] as const).map(open), ...languageNames] };
  return scopeOf(tree, { id: at, field: "when" }, services);
}
