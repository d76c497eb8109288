// Two people set the same field without knowing of each other: the server's order decides which value the document has. Both are kept here, until
// the person at this page has seen them and chosen. (An edit that the server refuses is a notice of the session.)
import type { AcceptedEdit } from "../../generated/messages";
import { entryOf, isObject, type JsonObject, type JsonValue } from "../json";
import type { Operation } from "./apply";
import { isOfComments } from "./comments/comments";
import { setOperation } from "./commands/setField";
import { isSame } from "./difference/same";
import type { Exact } from "./exact";
import type { Change, EditSession } from "./session";
import type { Tree } from "./tree";

/** A field of an element, of the document with an empty id; or an entry of one. */
export interface SetPlace {
  readonly id: string;
  readonly field: string;
  readonly key?: string;
}

/** What the person at this page has set lately. */
export interface OwnSet extends SetPlace {
  /** Nothing: it was taken away. */
  readonly mine: JsonValue | undefined;
  /** What has set it, and what sets it once more, as it was typed. */
  readonly change: Change;
  readonly again: Change;
  /** [ms] */
  readonly at: number;
}

export interface Conflict extends SetPlace {
  readonly mine: JsonValue | undefined;
  readonly theirs: JsonValue | undefined;
  readonly author: string;
  /** Sets it to `mine`. */
  readonly again: Change;
}

/** Who replaces a value later than this has seen it [ms]. */
export const kMoment = 10_000;
/** Of what was set lately, the last are known. */
const kMostOwn = 64;

/** Where a state stands is nothing that anybody has written; comments have authors of their own. */
const isOfInterest = ({ field, key }: SetPlace): boolean => field !== "layout" && !(field === "meta" && key !== undefined && isOfComments(key));

export const isAt = (one: SetPlace, other: SetPlace): boolean => one.id === other.id && one.field === other.field && one.key === other.key;

/** Whether a field of a form is this place: an entry is `field:key`, and names are one field in all forms. */
export function isField({ id, field, key }: SetPlace, element: string, shown: string): boolean {
  if (id !== element) return false;
  return shown === (key === undefined ? field : `${field}:${key}`) || (shown === "name" && key === undefined && (field === "state" || field === "barrier"));
}

const kNameFields: Readonly<Record<string, string>> = { state: "state", barrier: "barrier" };

function setsOf(change: Change, operations: readonly Operation[], tree: Tree): readonly Omit<OwnSet, "at">[] {
  if ("operations" in change)
    return operations.flatMap((operation, i) => {
      const exact = change.operations[i];
      if (operation.op !== "set" || exact === undefined || !isOfInterest(operation)) return [];
      const { id, field, key, value } = operation;
      return [{ id, field, ...(key !== undefined && { key }), mine: value, change, again: { operations: [exact] } }];
    });
  if (!("compound" in change) || change.compound.kind !== "rename") return [];
  const { id, name } = change.compound;
  return [{ id, field: kNameFields[tree.elements.get(id)?.kind ?? ""] ?? "name", mine: name, change, again: change }];
}

/** What was set lately, with what waits for the server now, and without what is long ago. */
export function ownSets(before: readonly OwnSet[], { pending, view }: Pick<EditSession, "pending" | "view">, now: number): readonly OwnSet[] {
  if (view === undefined) return before;
  const known = new Set(before.map(({ change }) => change));
  const waiting = new Set(pending.map(({ change }) => change));
  const kept = before.filter(({ change, at }) => waiting.has(change) || now - at < kMoment);
  const added = pending.filter(({ change }) => !known.has(change)).flatMap(({ change, operations }) => setsOf(change, operations, view).map((set) => ({ ...set, at: now })));
  return kept.length === before.length && added.length === 0 ? before : [...kept, ...added].slice(-kMostOwn);
}

/** Where an edit of somebody else meets what was set here; of a field that was set several times, the last. */
export function conflictsWith(own: readonly OwnSet[], { operations, author }: AcceptedEdit): readonly Conflict[] {
  const last = new Map<OwnSet, Conflict>();
  for (const operation of operations) {
    if (operation.op !== "set") continue;
    const met = [...own].reverse().find((set) => isAt(set, operation));
    if (met === undefined) continue;
    const { mine, again, id, field, key } = met;
    last.delete(met);
    if (!isSame(mine, operation.value)) last.set(met, { id, field, ...(key !== undefined && { key }), mine, theirs: operation.value, author, again });
  }
  return [...last.values()];
}

function objectIn(fields: JsonObject | undefined, field: string): JsonObject | undefined {
  const value = entryOf(fields, field);
  return isObject(value) ? value : undefined;
}

/** What the document has there; nothing: nothing, or no such element. */
export function valueAt(tree: Tree, { id, field, key }: SetPlace): JsonValue | undefined {
  const fields = id === "" ? tree.fields : tree.elements.get(id)?.fields;
  const within = id === "" && field === "notes" ? objectIn(fields, "meta") : fields;
  return key === undefined ? entryOf(within, field) : entryOf(objectIn(within, field), key);
}

/** Whether what was read from the document can be sent as it was written there: 1 may have been 1.0 (README.md). */
function isExact(value: JsonValue | undefined): boolean {
  if (typeof value === "number") return !Number.isInteger(value);
  return typeof value !== "object" || value === null || Object.values(value as Readonly<Record<string, JsonValue>>).every(isExact);
}

export interface Choices {
  /** Whose value the document has; nothing: another one by now, or none. */
  readonly holds: "mine" | "theirs" | undefined;
  /** What gives it the other value; nothing: it cannot be set from here. */
  readonly mine: Change | undefined;
  readonly theirs: Change | undefined;
}

/** What can be chosen now. */
export function choicesOf(conflict: Conflict, tree: Tree): Choices {
  const { id, field, key, mine, theirs, again } = conflict;
  const now = valueAt(tree, conflict);
  const holds = isSame(now, mine) ? "mine" : isSame(now, theirs) ? "theirs" : undefined;
  if (id !== "" && !tree.elements.has(id)) return { holds: undefined, mine: undefined, theirs: undefined };
  const takes: Change | undefined = !isExact(theirs) ? undefined : "compound" in again && typeof theirs === "string" ? { compound: { kind: "rename", id, name: theirs } } : { operations: [setOperation(id, field, theirs as Exact<JsonValue>, key)] };
  return { holds, mine: holds === "mine" ? undefined : again, theirs: holds === "theirs" ? undefined : takes };
}
