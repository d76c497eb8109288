// A difference in words: a row for each element, with a sign, for lists, and for marks in a drawing.
import { valueText } from "../../model/describe";
import type { JsonValue } from "../../json";
import { isOfComments } from "../comments/comments";
import { nameOfElement } from "../commands/command";
import { elementOf, type Element, type Tree } from "../tree";
import { allOf, outermostOf, type Difference, type FieldChange } from "./difference";

export type ChangeKind = "added" | "removed" | "moved" | "changed";

/** How each kind is marked, besides its colour. */
export const kSigns: Readonly<Record<ChangeKind, string>> = { added: "+", removed: "−", moved: "↕", changed: "≠" };

export interface DifferenceRow {
  readonly kind: ChangeKind;
  /** Empty: the document itself. */
  readonly id: string;
  /** The element, in the words of the tree that has it: `port Root/A.done`. */
  readonly name: string;
  /** What has become of it; empty: the kind says all. */
  readonly text: string;
}

const kMost = 60;
const clipped = (text: string): string => (text.length > kMost ? `${text.slice(0, kMost - 1)}…` : text);

/** Code as it is, other values as a task author would write them. */
const kCode: ReadonlySet<string> = new Set(["when", "do", "after", "from", "entry", "exit"]);
const written = (field: string, value: JsonValue): string => clipped(typeof value === "string" && kCode.has(field) ? value : valueText(value));

function fieldText({ field, key, before, after }: FieldChange): string {
  const name = key === undefined ? field : `${field} ${key}`;
  if (before === undefined) return after === undefined ? name : `${name}: ${written(field, after)}`;
  return after === undefined ? `${name}: no longer ${written(field, before)}` : `${name}: ${written(field, before)} → ${written(field, after)}`;
}

/** `Root/A`; of a state of the library, `library/Grasp/Close`. */
function pathOf(tree: Tree, { id, parent, list }: Element): string {
  const name = nameOfElement(tree, id);
  if (parent === "") return list === "library" ? `library/${name}` : name;
  return `${pathOf(tree, elementOf(tree, parent))}/${name}`;
}

const kWords: Readonly<Partial<Record<string, string>>> = { results: "result", variables: "variable", parameters: "parameter", actions: "action" };

/** An element as `DifferenceRow` names it. */
export function elementText(tree: Tree, id: string): string {
  const element = elementOf(tree, id);
  const { kind, parent, list } = element;
  if (kind === "state" || kind === "barrier") return `${kind} ${pathOf(tree, element)}`;
  const of = elementOf(tree, parent);
  if (kind === "port") return `port ${pathOf(tree, of)}.${nameOfElement(tree, id)}`;
  const name = kind === "action" ? String((of.lists.actions ?? []).indexOf(id) + 1) : nameOfElement(tree, id);
  return `${kWords[list ?? ""] ?? kind} ${name} of ${pathOf(tree, of)}`;
}

/** Where an element has come from: another state, another list, or another place in its list. */
function moveText(before: Tree, after: Tree, id: string): string {
  const [was, is] = [elementOf(before, id), elementOf(after, id)];
  if (was.parent === is.parent && was.list === is.list) return "in another order";
  return was.parent === is.parent ? `was in ${was.list ?? "the document"}` : `was in ${was.parent === "" ? "the library" : pathOf(before, elementOf(before, was.parent))}`;
}

/** What has no part in a run: where elements are drawn, and notes and comments on them. */
const isDrawing = ({ field, key }: FieldChange): boolean => field === "layout" || field === "notes" || (field === "meta" && key !== undefined && isOfComments(key));

/** Whether anything differs in where elements are drawn, or in the notes and comments on them. */
export const differsInDrawing = ({ document }: Difference): boolean => document.some(isDrawing);

/** What was added or removed within another one has no row. Of the drawing there is none. */
export function differenceRows(before: Tree, after: Tree, found: Difference): readonly DifferenceRow[] {
  const moved = new Set(found.moved);
  const fields = new Map(found.changed.map((each) => [each.id, each.fields]));
  const kept = allOf(after).filter((id) => moved.has(id) || fields.has(id));
  const about = found.document.filter((each) => !isDrawing(each));
  return [
    ...(about.length === 0 ? [] : [{ kind: "changed", id: "", name: "the document", text: about.map(fieldText).join(", ") } as const]),
    ...outermostOf(after, found.added).map((id): DifferenceRow => ({ kind: "added", id, name: elementText(after, id), text: "" })),
    ...outermostOf(before, found.removed).map((id): DifferenceRow => ({ kind: "removed", id, name: elementText(before, id), text: "" })),
    ...kept.map((id): DifferenceRow => {
      const changes = (fields.get(id) ?? []).map(fieldText);
      const texts = moved.has(id) ? [moveText(before, after, id), ...changes] : changes;
      return { kind: fields.has(id) ? "changed" : "moved", id, name: elementText(after, id), text: texts.join(", ") };
    }),
  ];
}
