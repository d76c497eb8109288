// Numbers as they were written. To the server `1.0` is a float and `1` an int, but both are 1 to JavaScript, which also rounds integers
// beyond 2^53. So a client never sends back what it has read; and what a user writes or pastes is read and sent by the functions below.
import type { JsonValue } from "./json.js";

/** A number that JavaScript would write in another way. */
export class NumberText {
  constructor(readonly text: string) {}
}

export type ExactJson = null | boolean | number | string | NumberText | readonly ExactJson[] | { readonly [key: string]: ExactJson };

/** `T`, the numbers of which may be as they were written. */
export type Exact<T> = JsonValue extends T ? ExactJson : T extends number ? T | NumberText : T extends object ? { readonly [K in keyof T]: Exact<T[K]> } : T;

const kToken = /"(?:[^"\\]|\\.)*"|-?\d[\d.eE+-]*/g;

/** Reads JSON. Throws SyntaxError. */
export function readExact(text: string): ExactJson {
  const value = JSON.parse(text) as JsonValue;
  // A text that no string of the value contains.
  let mark = "number ";
  while (JSON.stringify(value).includes(mark)) mark = `.${mark}`;
  const marked = text.replace(kToken, (token) => (token.startsWith('"') || String(Number(token)) === token ? token : `"${mark}${token}"`));
  return JSON.parse(marked, (_, item: JsonValue) => (typeof item === "string" && item.startsWith(mark) ? new NumberText(item.slice(mark.length)) : item)) as ExactJson;
}

/** Writes JSON: the inverse of readExact. Fields that are undefined are left out. Throws a TypeError for what JSON does not have. */
export function writeExact(value: unknown): string {
  if (value instanceof NumberText) return value.text;
  if (Array.isArray(value)) return `[${value.map(writeExact).join(",")}]`;
  if (typeof value !== "object" || value === null) return writeSimple(value);
  const entries = Object.entries(value).filter(([, item]) => item !== undefined);
  return `{${entries.map(([key, item]) => `${JSON.stringify(key)}:${writeExact(item)}`).join(",")}}`;
}

function writeSimple(value: unknown): string {
  if (typeof value === "number" && !Number.isFinite(value)) throw new TypeError(`JSON has no ${value}`);
  // Of what JSON does not have, it is undefined.
  const text = JSON.stringify(value) as string | undefined;
  if (text === undefined) throw new TypeError(`JSON has no ${typeof value}`);
  return text;
}

/** The value as JavaScript has it. */
export const plain = <T>(value: Exact<T>): T => JSON.parse(writeExact(value)) as T;
