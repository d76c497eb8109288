// Constants as a user reads and writes them: JSON in one line, with the numbers as the server has them.
import type { JsonValue } from "../json";
import { NumberText, type ExactJson } from "./exact";

/** JSON with a space after each comma and colon. */
export function exactLine(value: ExactJson): string {
  if (value instanceof NumberText) return value.text;
  if (Array.isArray(value)) return `[${value.map(exactLine).join(", ")}]`;
  if (typeof value !== "object" || value === null) return JSON.stringify(value);
  return `{${Object.entries(value)
    .map(([key, item]) => `${JSON.stringify(key)}: ${exactLine(item)}`)
    .join(", ")}}`;
}

/** Whether a value may have been written in another way than JavaScript writes it: 1.0 is 1 here. */
export function isInexact(value: JsonValue): boolean {
  if (typeof value === "number") return Number.isInteger(value);
  return typeof value === "object" && value !== null && Object.values(value).some(isInexact);
}
