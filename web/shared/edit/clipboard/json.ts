// Exact JSON (exact.ts): objects, and writing it with lines and indents.
import { NumberText, writeExact, type ExactJson } from "../exact";

export type ExactObject = Readonly<Record<string, ExactJson>>;

export const isExactObject = (value: ExactJson | undefined): value is ExactObject =>
  typeof value === "object" && value !== null && !Array.isArray(value) && !(value instanceof NumberText);

/** The elements of a list; none if it is no list. */
export const itemsOf = (value: ExactJson | undefined): readonly ExactJson[] => (Array.isArray(value) ? (value as readonly ExactJson[]) : []);

/** As writeExact, one entry on each line. */
export function writeLines(value: ExactJson, indent = ""): string {
  const inner = `${indent}  `;
  const [entries, open, close] = Array.isArray(value)
    ? [itemsOf(value).map((item) => writeLines(item, inner)), "[", "]"]
    : isExactObject(value)
      ? [Object.entries(value).map(([key, item]) => `${JSON.stringify(key)}: ${writeLines(item, inner)}`), "{", "}"]
      : [[], "", ""];
  return entries.length === 0 ? writeExact(value) : `${open}\n${entries.map((entry) => inner + entry).join(",\n")}\n${indent}${close}`;
}
