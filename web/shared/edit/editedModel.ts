// The document that is edited as the model that canvas, trees and panels draw. Drafts too: what is missing is empty. An element that did not
// change gives the object that it gave before, so that a page can compare by identity.
import { entryOf, isObject, type JsonObject, type JsonValue } from "../json";
import type { Action, Barrier, Declaration, Identified, Node, Parameter, Port, RcmDocument, State } from "../model/model";
import { elementOf, type Element, type Tree } from "./tree";

const textIn = (fields: JsonObject, field: string): string | undefined => {
  const value = entryOf(fields, field);
  return typeof value === "string" ? value : undefined;
};

const nameIn = (fields: JsonObject, field = "name"): string => textIn(fields, field) ?? "";

type Optional<T> = { readonly [K in keyof T]: T[K] | undefined };

/** Leaves out what is undefined. */
const present = <T extends object>(fields: Optional<T>): T => Object.fromEntries(Object.entries(fields).filter(([, value]) => value !== undefined)) as T;

const parameterOf = ({ id, fields }: Element): Parameter =>
  present<Parameter>({ id, name: nameIn(fields), value: entryOf(fields, "value"), from: textIn(fields, "from"), unit: textIn(fields, "unit"), doc: textIn(fields, "doc") });
const declarationOf = ({ id, fields }: Element): Declaration => ({ ...present<Declaration>({ id, name: nameIn(fields), initial: entryOf(fields, "initial") }) });
const actionOf = ({ id, fields }: Element): Action => ({ id, when: nameIn(fields, "when"), do: nameIn(fields, "do") });

/** A port without condition and time-out has an empty condition. */
function portOf({ id, fields }: Element): Port {
  const [when, after] = [textIn(fields, "when"), textIn(fields, "after")];
  const condition = after === undefined || when !== undefined ? { when: when ?? "" } : { after };
  return { id, name: nameIn(fields), ...present({ to: textIn(fields, "to") }), ...condition } as Port;
}

const textsOf = (value: JsonValue | undefined): readonly string[] => (Array.isArray(value) ? value.filter((item) => typeof item === "string") : []);
const barrierOf = ({ id, fields }: Element): Barrier => ({ kind: "barrier", id, name: nameIn(fields, "barrier"), to: textsOf(entryOf(fields, "to")) });

/** Siblings with the name of an earlier one get a key of their own: their name, and their number. Items without are as they were. */
function withKeys<T extends { readonly name: string; readonly key?: string }>(items: readonly T[]): readonly T[] {
  const seen = new Map<string, number>();
  return items.map((item) => {
    const count = (seen.get(item.name) ?? 0) + 1;
    seen.set(item.name, count);
    return count === 1 ? item : keyed(item, `${item.name}#${count}`);
  });
}

/** `item` with this key; the same object each time. */
function keyed<T extends { readonly key?: string }>(item: T, key: string): T {
  const known = keyedOnes.get(item) as T | undefined;
  if (known?.key === key) return known;
  const made = { ...item, key };
  keyedOnes.set(item, made);
  return made;
}
const keyedOnes = new WeakMap<object, object>();

interface Made<T> {
  readonly inner: readonly object[];
  readonly made: T;
}
const flat = new WeakMap<Element, Identified>();
const states = new WeakMap<Element, Made<State>>();

/** What `make` makes of an element without lists, once. */
function once<T extends Identified>(make: (element: Element) => T, element: Element): T {
  const known = flat.get(element) as T | undefined;
  if (known !== undefined) return known;
  const made = make(element);
  flat.set(element, made);
  return made;
}

function stateOf(tree: Tree, element: Element): State {
  const all = <T extends Identified>(list: keyof Element["lists"], make: (element: Element) => T) => (element.lists[list] ?? []).map((id) => once(make, elementOf(tree, id)));
  const lists = {
    parameters: all("parameters", parameterOf), results: all("results", declarationOf), variables: all("variables", declarationOf), actions: all("actions", actionOf),
    children: withKeys((element.lists.children ?? []).map((id): Node => nodeOf(tree, elementOf(tree, id)))), ports: withKeys(all("ports", portOf)),
  };
  const inner = Object.values(lists).flat();
  const before = states.get(element);
  if (before?.inner.length === inner.length && before.inner.every((item, i) => item === inner[i])) return before.made;
  const { fields } = element;
  const [keep, oracle] = [entryOf(fields, "keep"), entryOf(fields, "oracle")];
  const made = present<State>({
    kind: "state", id: element.id, name: nameIn(fields, "state"), key: undefined, doc: textIn(fields, "doc"), ...lists, entry: textIn(fields, "entry"), exit: textIn(fields, "exit"),
    first: textIn(fields, "first"), link: textIn(fields, "link"), keepsDeep: isObject(keep) && "deep" in keep ? true : undefined,
    oracle: isObject(oracle) ? textIn(oracle, "kind") : undefined, dispatcher: undefined,
  });
  states.set(element, { inner, made });
  return made;
}

const nodeOf = (tree: Tree, element: Element): Node => (element.kind === "barrier" ? once(barrierOf, element) : stateOf(tree, element));

const wholes = new WeakMap<Tree, Map<string, State>>();

/** A state of the document, with all in it: looked for once in each tree. Requires the id of a state. */
export function editedState(tree: Tree, id: string): State {
  const known = wholes.get(tree) ?? new Map<string, State>();
  wholes.set(tree, known);
  const state = known.get(id) ?? stateOf(tree, elementOf(tree, id));
  known.set(id, state);
  return state;
}

/** The whole document. */
export function editedModel(tree: Tree): RcmDocument {
  const services = entryOf(tree.fields, "services");
  const types = isObject(services) ? Object.entries(services).filter((entry): entry is [string, string] => typeof entry[1] === "string") : [];
  return { name: textIn(tree.fields, "name") ?? "", services: Object.fromEntries(types), library: tree.library.map((id) => editedState(tree, id)), root: editedState(tree, tree.root) };
}
