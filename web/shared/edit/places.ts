// Where the errors of a document are: the element, and the field of it, that a path and a message of the server are about.
import type { ServerError } from "../../generated/messages";
import type { ListName } from "./element";
import { nameOfElement } from "./commands/command";
import { listOf, type Tree } from "./tree";

export interface ErrorPlace {
  /** The element; empty: the document. */
  readonly id: string;
  /** Empty: the element as a whole. */
  readonly field: string;
  readonly error: ServerError;
}

type Place = Omit<ErrorPlace, "error">;

const kDocument: Place = { id: "", field: "" };

const named = (tree: Tree, ids: readonly string[], name: string): string | undefined => ids.find((id) => nameOfElement(tree, id) === name);

/** The node at a path of the server: `Root/A`, `library/Grasp/Close`. */
function nodeAt(tree: Tree, path: string): string | undefined {
  const [first, ...rest] = path.split("/");
  const isRoot = nameOfElement(tree, tree.root) === first;
  const names = isRoot ? rest : rest.slice(1);
  const top = isRoot ? tree.root : first === "library" ? named(tree, tree.library, rest[0] ?? "") : undefined;
  return names.reduce<string | undefined>((at, name) => at && named(tree, listOf(tree, at, "children"), name), top);
}

/** The element at a path: a node, or a port (`Root/A.success`). */
function elementAt(tree: Tree, path: string): string | undefined {
  const node = nodeAt(tree, path);
  const dot = path.lastIndexOf(".");
  if (node !== undefined || dot < 0) return node;
  const state = nodeAt(tree, path.slice(0, dot));
  return state && (named(tree, listOf(tree, state, "ports"), path.slice(dot + 1)) ?? state);
}

const kLists: Readonly<Record<string, ListName>> = { parameter: "parameters", result: "results", variable: "variables", port: "ports", child: "children" };

/** Fields by the codes of errors that are about one alone. */
const kFields: Readonly<Record<string, string>> = {
  port_target: "to", barrier_target: "to", first: "first", keep: "keep", link_unknown: "link", link_field: "link", link_cycle: "link", oracle: "oracle", missing: "when", after: "after", name: "name",
};

/** The place within the element `id`, of an error that is about no code: what its message names first ("parameter `x` ..."), or its code is about. */
function within(tree: Tree, id: string, { code, message }: ServerError): Place {
  const [, kind, name, declared] = /^(parameter|result|variable|port|child):? `([^`]*)`( is declared twice)?/.exec(message) ?? [];
  const list = kLists[kind ?? ""];
  if (list !== undefined) {
    const same = listOf(tree, id, list).filter((each) => nameOfElement(tree, each) === name);
    const found = declared === undefined ? same[0] : same[1];
    if (found !== undefined) return { id: found, field: declared !== undefined || code === "name" ? "name" : kind === "parameter" ? "from" : "" };
  }
  return { id, field: kFields[code] ?? "" };
}

/** What an error says, beside the field that it is about. */
export function messageAtField({ message, line, column }: ServerError): string {
  const text = message.replace(/^(?:entry|exit|oracle\b[^:]*|`(?:when|after|first)`|action \d+, `\w+`|(?:parameter|result|variable|port) `[^`]*`): /, "");
  return line === undefined || line === 1 ? text : `line ${line}${column === undefined ? "" : `, column ${column}`}: ${text}`;
}

/** The text of code that an error names; of what a link takes over from the library, the link. */
function textAt(tree: Tree, { path, id, text }: ServerError): Place | undefined {
  const element = id === undefined ? undefined : tree.elements.get(id);
  if (text === undefined || element === undefined) return undefined;
  const isTakenOver = text === "from" && element.parent !== elementAt(tree, path);
  return isTakenOver ? undefined : { id: element.id, field: text };
}

/** The place of one error; of what is not found, the document. */
export function placeOf(tree: Tree, error: ServerError): Place {
  const text = textAt(tree, error);
  if (text !== undefined) return text;
  const id = error.path === "" ? undefined : elementAt(tree, error.path);
  return id === undefined ? kDocument : within(tree, id, error);
}

/** Errors by element, in their order. */
export function placesOf(tree: Tree, errors: readonly ServerError[]): ReadonlyMap<string, readonly ErrorPlace[]> {
  const found = new Map<string, ErrorPlace[]>();
  for (const error of errors) {
    const place = { ...placeOf(tree, error), error };
    const known = found.get(place.id);
    if (known === undefined) found.set(place.id, [place]);
    else known.push(place);
  }
  return found;
}
