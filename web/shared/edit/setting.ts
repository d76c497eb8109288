// What the operation `set` makes of fields and their entries (core/edit/tree_fields.cpp). Everything that is refused throws Refusal with
// the field of the operation as path.
import type { EditSet } from "../../generated/messages";
import { entryOf, isObject, type JsonObject, type JsonValue } from "../json";
import { isList, readNode, writeElement } from "./element";
import { attempt, Refusal } from "./refusal";
import { orNothing, type Element } from "./tree";

/** Throws Refusal if a value is too deep for its place. */
type CheckDepth = (value: JsonValue) => void;

/** What fields are, and what was set was. */
export interface SetResult {
  readonly fields: JsonObject;
  readonly old: JsonValue | undefined;
}

/** `object` with the entry `key`, or without it. */
function exchange(object: JsonObject | undefined, key: string, value: JsonValue | undefined): SetResult {
  const rest = Object.entries(object ?? {}).filter(([each]) => each !== key);
  return { fields: Object.fromEntries(value === undefined ? rest : [...rest, [key, value]]), old: entryOf(object, key) };
}

/** The same of an object that is an entry itself, and is left out if it is empty. */
function exchangeWithin(fields: JsonObject, field: string, key: string, value: JsonValue | undefined): SetResult {
  const entries = entryOf(fields, field);
  if (entries !== undefined && !isObject(entries)) throw new Refusal("type", `\`${field}\` is no object`, "value");
  const { fields: inner, old } = exchange(entries, key, value);
  return { fields: exchange(fields, field, orNothing(inner)).fields, old };
}

const missingKey = (): Refusal => new Refusal("missing", "the field `key` is missing: an entry of the field", "key");
const noField = (field: string): Refusal => new Refusal("unknown_field", `there is no field \`${field}\``, "field");
const noEntries = (field: string): Refusal => new Refusal("unknown_field", `\`${field}\` has no entries`, "key");
const mustBeText = (field: string): Refusal => new Refusal("type", `\`${field}\` must be a string`, "value");

/** A field of the document: its name, or an entry. */
export function setDocumentField(fields: JsonObject, { field, key, value }: EditSet, checkDepth: CheckDepth): SetResult {
  if (field === "name") {
    if (key !== undefined) throw noEntries(field);
    if (value !== undefined && typeof value !== "string") throw mustBeText(field);
    return exchange(fields, field, value === "" ? undefined : value);
  }
  if (field !== "services" && field !== "layout" && field !== "notes" && field !== "meta") throw noField(field);
  if (key === undefined) throw missingKey();
  if ((field === "services" || field === "notes") && value !== undefined && typeof value !== "string") throw mustBeText(field);
  if (value !== undefined) checkDepth(value);
  if (field !== "notes") {
    if (field === "meta" && key === "notes") throw new Refusal("not_accepted", "notes are the field `notes`", "key");
    return exchangeWithin(fields, field, key, value);
  }
  const meta = entryOf(fields, "meta") ?? {};
  if (!isObject(meta)) throw new Refusal("type", "the `meta` of the document is no object", "value");
  const { fields: changed, old } = exchangeWithin(meta, "notes", key, value);
  return { fields: exchange(fields, "meta", orNothing(changed)).fields, old };
}

/** An entry of the `meta` of an element. */
export function setMetaEntry({ fields }: Element, { field, key, value }: EditSet, checkDepth: CheckDepth): SetResult {
  if (key === undefined) throw missingKey();
  if (key === "id") throw new Refusal("not_accepted", "an element keeps its id", "key");
  if (value !== undefined) checkDepth(value);
  return exchangeWithin(fields, field, key, value);
}

/** Another field of an element: it must be possible to read the element with it. */
export function setElementField({ kind, list = "children", fields }: Element, { field, key, value }: EditSet, checkDepth: CheckDepth): SetResult {
  if (key !== undefined) throw noEntries(field);
  if (isList(field)) throw noField(field);
  if (value !== undefined) checkDepth(value);
  const { fields: json, old } = exchange(writeElement(kind, fields, {}), field, value);
  const read = attempt(() => readNode(json, list));
  if (read instanceof Refusal) throw read.at(read.code === "unknown_field" ? "field" : "value");
  if (read.kind !== kind) throw noField(field);
  return { fields: read.fields, old };
}
