// The fields of elements: what a document accepts in each, and the form in which it is kept. A draft may break any other
// constraint; so these are weaker than api/schemas/document.json (core/rcm/read.cpp is the same in C++).
import { entryOf, isObject, type JsonObject, type JsonValue } from "../json";
import { Refusal } from "./refusal";

/** What is kept of a field; nothing of one that is absent or says nothing. Throws Refusal. */
export type FieldReader = (value: JsonValue | undefined, field: string) => JsonValue | undefined;

const wrongType = (field: string, expected: string): Refusal => new Refusal("type", `\`${field}\` must be ${expected}`);

const isTexts = (value: JsonValue | undefined): value is readonly string[] => Array.isArray(value) && value.every((item) => typeof item === "string");

export const text: FieldReader = (value, field) => {
  if (value === undefined || typeof value === "string") return value;
  throw wrongType(field, "a string");
};

export const requiredText: FieldReader = (value, field) => {
  if (value === undefined) throw new Refusal("missing", `the field \`${field}\` is missing`);
  return text(value, field);
};

/** An empty one is none. */
export const description: FieldReader = (value, field) => {
  const found = text(value, field);
  return found === "" ? undefined : found;
};

export const requiredTexts: FieldReader = (value, field) => {
  if (value === undefined) throw new Refusal("missing", `the field \`${field}\` is missing`);
  if (isTexts(value)) return value;
  throw wrongType(field, "a list of strings");
};

function hasFiniteNumbers(value: JsonValue): boolean {
  if (typeof value === "number") return Number.isFinite(value);
  if (typeof value !== "object" || value === null) return true;
  return Object.values(value).every(hasFiniteNumbers);
}

/** Any JSON. */
export const constant: FieldReader = (value, field) => {
  if (value === undefined || hasFiniteNumbers(value)) return value;
  throw new Refusal("constant", `\`${field}\` has a number out of the range of a double`);
};

/** `deep`: true, or absent. */
const deep: FieldReader = (value) => {
  if (value === undefined || value === true) return value;
  throw wrongType("deep", "true");
};

const ports: FieldReader = (value, field) => (value === undefined ? undefined : requiredTexts(value, field));

export const keep: FieldReader = (value, field) => {
  if (value === undefined || value === true || isTexts(value)) return value;
  if (!isObject(value)) throw wrongType(field, "true, a list of ports or an object");
  if (value.deep === undefined) throw new Refusal("missing", "the field `deep` is missing");
  return readFields(value, { deep, ports });
};

const kPlainTypes: readonly JsonValue[] = ["any", "null", "bool", "int", "number", "string", "pose", "image"];
const kName = /^[A-Za-z_][A-Za-z0-9_]*$/;

/** api/schemas/type.json */
function isType(type: JsonValue): boolean {
  if (!isObject(type)) return kPlainTypes.includes(type);
  const keys = Object.keys(type).sort().join();
  const { list, size, record, optional, enum: constants } = type;
  if (keys === "list" || keys === "list,size") return list !== undefined && isType(list) && (size === undefined || (Number.isInteger(size) && Number(size) >= 0));
  if (keys === "record") return isObject(record) && Object.entries(record).every(([key, field]) => kName.test(key) && isType(field));
  if (keys === "optional") return optional !== undefined && isType(optional);
  return keys === "enum" && Array.isArray(constants) && constants.length > 0 && hasFiniteNumbers(constants);
}

export const type: FieldReader = (value, field) => {
  if (value === undefined || isType(value)) return value;
  throw wrongType(field, "a type");
};

/** The fields that an oracle of a kind has besides `kind`. */
const kOracles: Readonly<Record<string, Readonly<Record<string, FieldReader>>>> = {
  expr: { expr: requiredText },
  external: { call: requiredText },
  history: { resume: ports, deep },
};

export const oracle: FieldReader = (value, field) => {
  if (value === undefined) return undefined;
  if (!isObject(value)) throw wrongType(field, "an object");
  const kind = requiredText(entryOf(value, "kind"), "kind");
  const fields = typeof kind === "string" && Object.hasOwn(kOracles, kind) ? kOracles[kind] : undefined;
  if (fields === undefined) throw new Refusal("oracle", `there is no oracle of the kind ${JSON.stringify(kind)}`);
  return readFields(value, { kind: requiredText, ...fields });
};

const kId = /^[A-Za-z0-9_-]{1,64}$/;

/** Any JSON; in an object, `id` is an id. */
export const meta: FieldReader = (value, field) => {
  const found = constant(value, field) ?? undefined;
  const id = isObject(found) ? entryOf(found, "id") : undefined;
  if (id === undefined || (typeof id === "string" && kId.test(id))) return isObject(found) && Object.keys(found).length === 0 ? undefined : found;
  throw new Refusal("type", "`meta.id` must be a text of 1 to 64 of A-Z a-z 0-9 _ -");
};

/** The fields of an object, in the order of `format`; a field that is not in it is refused. */
export function readFields(json: JsonObject, format: Readonly<Record<string, FieldReader>>): JsonObject {
  const read = Object.entries(format).map(([field, reader]) => [field, reader(entryOf(json, field), field)] as const);
  const unknown = Object.keys(json).find((field) => !Object.hasOwn(format, field));
  if (unknown !== undefined) throw new Refusal("unknown_field", `there is no field \`${unknown}\``);
  return Object.fromEntries(read.filter((field): field is [string, JsonValue] => field[1] !== undefined));
}
