// Whether a value has a type (TYPE of core/SEMANTICS.md section 1), with the numbers as they are written.
import type { Type as WrittenType } from "../../generated/messages";
import { NumberText, plain, writeExact, type Exact, type ExactJson } from "../edit/exact";

/** A type, with the numbers of its values as they are written. */
export type Type = Exact<WrittenType>;

type Entries = Readonly<Record<string, ExactJson>>;

const isNumber = (value: ExactJson): boolean => typeof value === "number" || value instanceof NumberText;
const isList = (value: ExactJson): value is readonly ExactJson[] => Array.isArray(value);
const isEntries = (value: ExactJson): value is Entries => typeof value === "object" && value !== null && !isList(value) && !(value instanceof NumberText);

const kMaxInt = 2n ** 63n;

/** Whole, without point and exponent, of 64 bits. */
function isInt(value: ExactJson): boolean {
  const text = writeExact(value);
  return isNumber(value) && /^-?\d+$/.test(text) && BigInt(text) < kMaxInt && BigInt(text) >= -kMaxInt;
}

/** 1 is 1.0 here, as `==` has it. */
const equal = (a: ExactJson, b: ExactJson): boolean => JSON.stringify(plain(a)) === JSON.stringify(plain(b));

const kPose = { record: { position: { list: "number", size: 3 }, orientation: { list: "number", size: 4 } } } as const;

/** The kinds of values that a type has, for people. */
export function typeText(type: Type): string {
  if (typeof type === "string") return { any: "any value", null: "null", bool: "true or false", int: "a whole number", number: "a number", string: "a text", pose: "a pose", image: "an image" }[type];
  if ("list" in type) return `a list of ${type.size === undefined ? "" : `${writeExact(type.size)} `}${plural(type.list)}`;
  if ("record" in type) return `an object with ${Object.keys(type.record).join(", ") || "nothing"}`;
  if ("enum" in type) return `one of ${type.enum.map(writeExact).join(", ")}`;
  return `${typeText(type.optional)}, or null`;
}

const plural = (type: Type): string => (type === "number" ? "numbers" : type === "int" ? "whole numbers" : type === "string" ? "texts" : "values");

const within = (place: string, problem: string | undefined): string | undefined => problem && `${place}: ${problem}`;
const first = (problems: Iterable<string | undefined>): string | undefined => [...problems].find((problem) => problem !== undefined);

function entriesMismatch(fields: Readonly<Record<string, Type>>, value: Entries): string | undefined {
  const strange = Object.keys(value).find((name) => !Object.hasOwn(fields, name));
  if (strange !== undefined) return `there is no field \`${strange}\``;
  return first(
    Object.entries(fields).map(([name, type]) => {
      const item = Object.hasOwn(value, name) ? value[name] : undefined;
      if (item !== undefined) return within(name, mismatch(type, item));
      return !(typeof type === "object" && "optional" in type) ? `the field \`${name}\` is missing` : undefined;
    }),
  );
}

/** What is wrong with the value; nothing if it has the type. */
export function mismatch(type: Type, value: ExactJson): string | undefined {
  const expected = (fits: boolean): string | undefined => (fits ? undefined : `must be ${typeText(type)}`);
  if (typeof type === "object") {
    if ("optional" in type) return value === null ? undefined : mismatch(type.optional, value);
    if ("enum" in type) return expected(type.enum.some((item) => equal(value, item)));
    if ("record" in type) return isEntries(value) ? entriesMismatch(type.record, value) : expected(false);
    if (!isList(value) || (type.size !== undefined && value.length !== Number(writeExact(type.size)))) return expected(false);
    return first(value.map((item, i) => within(`item ${i + 1}`, mismatch(type.list, item))));
  }
  switch (type) {
    case "any": return undefined;
    case "null": return expected(value === null);
    case "bool": return expected(typeof value === "boolean");
    case "int": return expected(isInt(value));
    case "number": return expected(isNumber(value));
    case "string": return expected(typeof value === "string");
    case "pose": return isEntries(value) ? entriesMismatch(kPose.record, value) : expected(false);
    case "image": return expected(isEntries(value) && isInt(value["width"] ?? null) && isInt(value["height"] ?? null));
  }
}
