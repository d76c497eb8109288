// What a service may say: values that the server reads as they are.
import type { JsonObject, JsonValue } from "../json.js";

/** Levels of lists and objects (api/schemas/component_request.json). */
const kLevels = 64;
/** Of UTF-16, without its other half: UTF-8 has none. */
const kLoneSurrogate = /\p{Surrogate}/gu;

/**
 * The value as it is sent; nothing is null, and a field that is undefined is left out. Throws a TypeError or a RangeError: it is no JSON,
 * or has a number that is not finite or an integer of more than 64 bits, text that is no Unicode, or more than 64 levels.
 */
export function checkedValue(value: unknown): JsonValue {
  if (value === undefined) return null;
  check(value, kLevels);
  return value as JsonValue;
}

function check(value: unknown, levels: number): void {
  if (typeof value === "string") checkText(value);
  else if (typeof value === "number") checkNumber(value);
  else if (typeof value === "object" && value !== null) checkEntries(value, levels);
  else if (typeof value !== "boolean" && value !== null) throw new TypeError(`JSON has no ${typeof value}`);
}

function checkText(text: string): void {
  if (text.search(kLoneSurrogate) >= 0) throw new TypeError("a text has half a character");
}

function checkNumber(value: number): void {
  if (!Number.isFinite(value)) throw new RangeError(`JSON has no ${value}`);
  // From 1e21 on, it is written with an exponent, as no integer.
  const isInteger = Number.isInteger(value) && Math.abs(value) < 1e21;
  if (isInteger && (value >= 2 ** 63 || value < -(2 ** 63))) throw new RangeError(`${value} has more than 64 bits`);
}

function checkEntries(value: object, levels: number): void {
  if (levels === 0) throw new RangeError(`a value has more than ${kLevels} levels`);
  if (Array.isArray(value)) {
    for (const each of value as readonly unknown[]) check(each, levels - 1);
    return;
  }
  const prototype: unknown = Object.getPrototypeOf(value);
  if (prototype !== null && prototype !== Object.prototype) throw new TypeError(`JSON has no ${value.constructor.name}`);
  for (const [key, each] of Object.entries(value) as readonly (readonly [string, unknown])[]) {
    checkText(key);
    if (each !== undefined) check(each, levels - 1);
  }
}

/** The error of an operation, or what is wrong with that. */
export function checkedError(error: JsonObject): JsonObject & { readonly code: string } {
  try {
    const { code } = error;
    if (typeof code !== "string") throw new TypeError("its `code` is no text");
    checkedValue(error);
    return { ...error, code };
  } catch (wrong) {
    return { code: "failed", message: shortText(`the error of the operation is none: ${messageOf(wrong)}`, 500) };
  }
}

/** So many characters of a text at most. */
export const shortText = (text: string, most: number): string => text.slice(0, most).replace(kLoneSurrogate, "\ufffd");

/** What something says that was thrown. */
export const messageOf = (thrown: unknown): string => (thrown instanceof Error ? thrown.message : String(thrown));
