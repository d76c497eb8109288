// Entry of a number by keys, and its limits: the logic of the numeric keypad.
import type { NumberEntry } from "../../generated/messages";

export type Key = "0" | "1" | "2" | "3" | "4" | "5" | "6" | "7" | "8" | "9" | "." | "sign" | "back";

const kLength = 12;

/** The text after `key`; a key that is not valid here changes nothing. */
export function press(text: string, key: Key): string {
  if (key === "back") return text.slice(0, -1);
  if (key === "sign") return text.startsWith("-") ? text.slice(1) : `-${text}`;
  if (text.length >= kLength || (key === "." && text.includes("."))) return text;
  const digits = text.replace("-", "");
  if (key === ".") return digits === "" ? `${text}0.` : `${text}.`;
  return digits === "0" ? `${text.slice(0, -1)}${key}` : `${text}${key}`;
}

/** The key of a keyboard that does the same. */
export function keyOf(name: string): Key | undefined {
  if (/^[0-9.]$/.test(name)) return name as Key;
  if (name === ",") return ".";
  if (name === "-") return "sign";
  return name === "Backspace" ? "back" : undefined;
}

/** The number in `text` if it is within the limits, else the problem as a text for the user. */
export function read(text: string, entry: NumberEntry): { readonly value: number } | { readonly problem: string } {
  if (!/\d/.test(text)) return { problem: "Enter a number" };
  const value = Number(text);
  if (value < entry.min) return { problem: `At least ${withUnit(entry.min, entry)}` };
  if (value > entry.max) return { problem: `At most ${withUnit(entry.max, entry)}` };
  return { value };
}

/** The initial text of the field. */
export const proposed = (entry: NumberEntry): string => (entry.value === undefined ? "" : String(entry.value));

export const limits = (entry: NumberEntry): string => `${entry.min} to ${withUnit(entry.max, entry)}`;

const withUnit = (value: number, entry: NumberEntry): string => (entry.unit === "" ? String(value) : `${value} ${entry.unit}`);
