// A value as a literal of the function language: nothing is cut or rounded, so two different values have different texts
// (but JavaScript rounds integers beyond 2^53).
import type { JsonValue } from "../json";

/**
 * `value` as a task author could write it: None, True, False, numbers with all their digits, strings in single quotes, lists, dicts.
 * Keys are in JavaScript's order: whole numbers first. An integer and a float of the same value have the same text.
 */
export function literal(value: JsonValue): string {
  if (value === null) return "None";
  if (typeof value === "boolean") return value ? "True" : "False";
  if (typeof value === "number") return Object.is(value, -0) ? "-0.0" : String(value);
  if (typeof value === "string") return quoted(value);
  if (Array.isArray(value)) return `[${value.map(literal).join(", ")}]`;
  return `{${Object.entries(value)
    .map(([key, entry]) => `${quoted(key)}: ${literal(entry)}`)
    .join(", ")}}`;
}

const kEscapes: Readonly<Record<string, string>> = { "\\": "\\\\", "'": "\\'", "\n": "\\n", "\r": "\\r", "\t": "\\t" };

/** Spaces stay as they are; what would break the line or end the string is escaped. */
function quoted(text: string): string {
  return `'${text.replace(/[\\'\n\r\t]/g, (character) => kEscapes[character] ?? character)}'`;
}
