// The texts of a document in the function language, and whose names they may use (core/edit/references.h).
import { entryOf, isObject } from "../json";
import { elementOf, listOf, type Element, type Tree } from "../edit/tree";
import { nameOfElement } from "../edit/commands/command";

/** The kinds of code of core/language: a condition is three-valued, an expression sees no services and ports. */
export type CodeKind = "condition" | "expression" | "function";

/** The field of an element that is a text of code; `oracle` is the expression or call in it. */
export type CodeFieldName = "entry" | "exit" | "when" | "after" | "do" | "from" | "oracle";

export interface CodeText {
  readonly id: string;
  readonly field: CodeFieldName;
  readonly text: string;
  readonly kind: CodeKind;
}

const textIn = (element: Element, field: string): string | undefined => {
  const value = entryOf(element.fields, field);
  return typeof value === "string" ? value : undefined;
};

/** The kind of a text that stands in a field of this name. */
export const kindOf = (field: CodeFieldName): CodeKind => (field === "when" ? "condition" : field === "after" || field === "from" ? "expression" : "function");

function textsOf(tree: Tree, id: string, fields: readonly CodeFieldName[]): readonly CodeText[] {
  const element = elementOf(tree, id);
  return fields.flatMap((field): readonly CodeText[] => {
    const text = textIn(element, field);
    return text === undefined ? [] : [{ id, field, text, kind: kindOf(field) }];
  });
}

function oracleText(tree: Tree, id: string): readonly CodeText[] {
  const oracle = entryOf(elementOf(tree, id).fields, "oracle");
  if (!isObject(oracle)) return [];
  const [expression, call] = [entryOf(oracle, "expr"), entryOf(oracle, "call")];
  if (typeof expression === "string") return [{ id, field: "oracle", text: expression, kind: "expression" }];
  return typeof call === "string" ? [{ id, field: "oracle", text: call, kind: "function" }] : [];
}

/** The `from` of a state's own parameters: of its parent's scope; of a state of the library, of that of each state that links it. */
export const fromTexts = (tree: Tree, state: string): readonly CodeText[] => listOf(tree, state, "parameters").flatMap((id) => textsOf(tree, id, ["from"]));

/** The texts that use the names of a state: its own, those of its actions and ports, and the `from` of its children's parameters. */
export const textsInScope = (tree: Tree, state: string): readonly CodeText[] => [
  ...textsOf(tree, state, ["entry", "exit"]),
  ...oracleText(tree, state),
  ...listOf(tree, state, "actions").flatMap((id) => textsOf(tree, id, ["when", "do"])),
  ...listOf(tree, state, "ports").flatMap((id) => textsOf(tree, id, ["when", "after"])),
  ...listOf(tree, state, "children").flatMap((child) => fromTexts(tree, child)),
];

/** The state of the library that a state links; nothing if it links none, or one that is not there. */
export function linkedBy(tree: Tree, state: string): string | undefined {
  const element = tree.elements.get(state);
  const link = element && textIn(element, "link");
  return link === undefined ? undefined : tree.library.find((id) => nameOfElement(tree, id) === link);
}

/** The state whose behaviour a state has: itself, or where its links lead; nothing if they lead nowhere. */
export function behaviourOf(tree: Tree, state: string): string | undefined {
  let at: string | undefined = state;
  for (let links = 0; at !== undefined && links <= tree.library.length; ++links) {
    const element: Element | undefined = tree.elements.get(at);
    if (element === undefined || textIn(element, "link") === undefined) return at;
    at = linkedBy(tree, at);
  }
  return undefined;
}

export const statesOf = (tree: Tree): readonly string[] => [...tree.elements.values()].filter(({ kind }) => kind === "state").map(({ id }) => id);
