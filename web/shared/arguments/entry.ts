// What is typed into the form for the arguments of a run, and the arguments that it says.
import { readExact, writeExact, type ExactJson } from "../edit/exact";
import { mismatch, typeText, type Type } from "./mismatch";
import type { RunParameter } from "./parameters";

/** How a value is entered: chosen from JSON texts, as a number, as a text, or as JSON. */
export type Input = { readonly kind: "choice"; readonly choices: readonly string[] } | { readonly kind: "number" | "text" | "json" };

export function inputOf(type: Type): Input {
  if (type === "bool") return { kind: "choice", choices: ["true", "false"] };
  if (type === "int" || type === "number") return { kind: "number" };
  if (type === "string") return { kind: "text" };
  if (typeof type === "object" && "enum" in type) return { kind: "choice", choices: type.enum.map(writeExact) };
  return { kind: "json" };
}

/** What stands in the field before anything is typed: the value that the parameter has without an argument. */
export function firstText({ initial, type }: RunParameter): string {
  if (initial === undefined || inputOf(type).kind !== "text") return initial ?? "";
  const value = readExact(initial);
  return typeof value === "string" ? value : initial;
}

/** What the field says: an argument, or what is wrong; nothing: the parameter keeps its own value. */
export type Reading = { readonly value: ExactJson } | { readonly problem: string } | undefined;

const kNumber = /^-?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?$/;

/** Throws SyntaxError if the text is not JSON. */
function valueOf(text: string, type: Type): ExactJson {
  const { kind } = inputOf(type);
  return kind === "text" ? text : readExact(text);
}

function outOfRange({ min, max }: RunParameter, value: ExactJson): string | undefined {
  const number = Number(writeExact(value));
  if (min !== undefined && number < min) return `must be at least ${min}`;
  return max !== undefined && number > max ? `must be at most ${max}` : undefined;
}

/** Reads a field. A text that was not changed says nothing, so that the number of the document stays as it is written. */
export function readField(parameter: RunParameter, typed: string): Reading {
  const { type, initial } = parameter;
  const { kind } = inputOf(type);
  const text = kind === "text" ? typed : typed.trim();
  if (initial !== undefined && text === firstText(parameter)) return undefined;
  if (text === "" && (kind !== "text" || initial === undefined)) return { problem: "needs a value" };
  if (kind === "number" && !kNumber.test(text)) return { problem: `must be ${typeText(type)}, such as ${type === "int" ? "3" : "0.25"}` };
  try {
    const value = valueOf(text, type);
    const problem = mismatch(type, value) ?? (kind === "number" ? outOfRange(parameter, value) : undefined);
    return problem === undefined ? { value } : { problem };
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error;
    return { problem: `is not JSON, such as {"a": [1, 0.5, "text"]}` };
  }
}

/** The arguments of a run as they are sent, or what is wrong, by parameter. */
export type Arguments = { readonly values: Readonly<Record<string, ExactJson>> } | { readonly problems: Readonly<Record<string, string>> };

/** Reads the form: `texts`, by parameter; those that are missing are as they were at first. */
export function readArguments(parameters: readonly RunParameter[], texts: Readonly<Record<string, string>>): Arguments {
  const readings = parameters.map((parameter) => [parameter.name, readField(parameter, texts[parameter.name] ?? firstText(parameter))] as const);
  const problems = readings.flatMap(([name, reading]) => (reading !== undefined && "problem" in reading ? [[name, reading.problem] as const] : []));
  if (problems.length > 0) return { problems: Object.fromEntries(problems) };
  return { values: Object.fromEntries(readings.flatMap(([name, reading]) => (reading !== undefined && "value" in reading ? [[name, reading.value] as const] : []))) };
}

/** What a field expects, with unit and bounds, for people. */
export function expectation({ type, unit, min, max }: RunParameter): string {
  const bounds = min !== undefined && max !== undefined ? `${min} to ${max}` : min !== undefined ? `at least ${min}` : max !== undefined ? `at most ${max}` : undefined;
  return [typeText(type), unit === undefined ? undefined : `in ${unit}`, bounds].filter((part) => part !== undefined).join(", ");
}
