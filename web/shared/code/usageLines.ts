// Usages as lines to read: where each is, and the line of code that has the name.
import { nameOfElement } from "../edit/commands/command";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf, isObject } from "../json";
import type { Referent } from "./referent";
import type { Usage } from "./usages";

export interface UsageLine {
  readonly usage: Usage;
  /** `Root/A.done, condition` */
  readonly place: string;
  /** Around the name, in its line of code; of another place, what it says. */
  readonly before: string;
  readonly name: string;
  readonly after: string;
}

/** `Root/A`, `Root/A.done`, `library/Grasp`; of an element that has no place of its own, that of its state. */
function pathOf(tree: Tree, id: string): string {
  const { kind, parent, list } = elementOf(tree, id);
  const name = nameOfElement(tree, id);
  if (parent === "") return list === "library" ? `library/${name}` : name;
  if (kind === "port") return `${pathOf(tree, parent)}.${name}`;
  return kind === "state" || kind === "barrier" ? `${pathOf(tree, parent)}/${name}` : pathOf(tree, parent);
}

const kFields: Readonly<Record<string, string>> = { when: "condition", do: "function", after: "time-out", from: "expression", to: "target", first: "first", keep: "keeps its values", oracle: "oracle", link: "link", name: "redefined" };

function placeOf(tree: Tree, { id, field }: Usage): string {
  if (id === "") return "the document, services";
  const { kind, parent } = elementOf(tree, id);
  const of = kind === "action" ? `action ${listOf(tree, parent, "actions").indexOf(id) + 1}, ` : kind === "parameter" ? `parameter ${nameOfElement(tree, id)}, ` : "";
  return `${pathOf(tree, id)}, ${of}${kFields[field] ?? field}`;
}

/** The text of code that a usage stands in. */
function textOf(tree: Tree, { id, field }: Usage): string {
  const value = entryOf(elementOf(tree, id).fields, field);
  const text = isObject(value) ? (entryOf(value, "expr") ?? entryOf(value, "call")) : value;
  return typeof text === "string" ? text : "";
}

/** What is looked for, as a name: `port done of Root/A`. */
export function referentText(tree: Tree, referent: Referent): string {
  switch (referent.kind) {
    case "element": {
      const { kind, parent, list } = elementOf(tree, referent.id);
      if (list === undefined || list === "children" || list === "library") return `${kind} ${pathOf(tree, referent.id)}`;
      return `${kind} ${nameOfElement(tree, referent.id)} of ${pathOf(tree, parent)}`;
    }
    case "variable":
      return `variable ${referent.name} of ${pathOf(tree, referent.state)}`;
    case "service":
      return referent.member === undefined ? `service ${referent.key}` : `${referent.member} of the service ${referent.key}`;
  }
}

/** The name that is used. */
export const referentName = (tree: Tree, referent: Referent): string =>
  referent.kind === "element" ? nameOfElement(tree, referent.id) : referent.kind === "variable" ? referent.name : (referent.member ?? referent.key);

export function usageLine(tree: Tree, usage: Usage, name: string): UsageLine {
  const place = placeOf(tree, usage);
  if (usage.span === undefined) return { usage, place, before: "", name, after: "" };
  const { from, to } = usage.span;
  const text = textOf(tree, usage);
  const start = text.lastIndexOf("\n", from - 1) + 1;
  const end = text.indexOf("\n", to);
  return { usage, place, before: text.slice(start, from).trimStart(), name: text.slice(from, to), after: text.slice(to, end < 0 ? undefined : end).trimEnd() };
}
