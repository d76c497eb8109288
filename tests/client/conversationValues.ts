// Values and patterns of api/conversations (its README says what they mean).
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { NumberText, plain, readExact, type ExactJson, type JsonValue } from "../../api/typescript/src/index";
import { project } from "./servers";

export const folder = join(project, "api/conversations");

export type Fields = Readonly<Record<string, ExactJson>>;

export const isFields = (value: unknown): value is Fields => typeof value === "object" && value !== null && !Array.isArray(value) && !(value instanceof NumberText);
export const isList = (value: unknown): value is readonly ExactJson[] => Array.isArray(value);

/** What was saved; else a task, or an example of api/examples, by its name, with its numbers as they were written. */
export class Values {
  private readonly known = new Map<string, ExactJson>();

  get(name: string): ExactJson {
    const known = this.known.get(name);
    if (known !== undefined) return known;
    const file = [join(folder, "tasks", `${name}.json`), join(project, "api/examples", `${name}.json`)].find(existsSync);
    if (file === undefined) throw new Error(`nothing is named ${name}`);
    return readExact(readFileSync(file, "utf8"));
  }
  set(name: string, value: ExactJson): void {
    this.known.set(name, value);
  }
}

/** What is given in a step, with what its names mean. */
export function valueOf(given: ExactJson, saved: Values): ExactJson {
  if (typeof given === "string" && given.startsWith("$")) return saved.get(given.slice(1));
  if (isList(given)) return given.map((each) => valueOf(each, saved));
  if (!isFields(given)) return given;
  const { $change: whole, set } = given;
  if (whole !== undefined && isFields(set)) {
    return Object.entries(set).reduce((value, [pointer, each]) => changed(value, pointer.split("/").slice(1), valueOf(each, saved)), valueOf(whole, saved));
  }
  return Object.fromEntries(Object.entries(given).map(([key, each]) => [key, valueOf(each, saved)]));
}

/** The part of a value at a JSON pointer; -1 is the last of a list. */
export function at(value: ExactJson, pointer: string): ExactJson {
  const found = pointer.split("/").slice(1).reduce<ExactJson | undefined>((whole, key) => (isList(whole) ? whole.at(Number(key)) : isFields(whole) ? whole[key] : undefined), value);
  if (found === undefined) throw new Error(`nothing is at ${pointer}`);
  return found;
}

/** A copy with another value at these keys. */
function changed(value: ExactJson, [key, ...further]: readonly string[], next: ExactJson): ExactJson {
  if (key === undefined) return next;
  if (isList(value)) return value.map((each, i) => (String(i) === key ? changed(each, further, next) : each));
  if (!isFields(value)) throw new Error(`nothing is at ${key}`);
  return { ...value, [key]: changed(value[key] ?? null, further, next) };
}

/** Whether two JSON values are equal, as JavaScript has them. */
function same(one: ExactJson, other: ExactJson): boolean {
  if (isList(one) && isList(other)) return one.length === other.length && one.every((each, i) => same(each, other[i] ?? null));
  if (!isFields(one) || !isFields(other)) return one === other;
  const keys = Object.keys(one);
  return keys.length === Object.keys(other).length && keys.every((key) => Object.hasOwn(other, key) && same(one[key] ?? null, other[key] ?? null));
}

const fits = (pattern: ExactJson, value: ExactJson, saved: Values): boolean => mismatch(pattern, value, saved) === undefined;
/** What is given, with numbers as JavaScript has them. */
const meant = (given: ExactJson, saved: Values): ExactJson => plain<JsonValue>(valueOf(given, saved));

function inOrder(patterns: readonly ExactJson[], value: readonly ExactJson[], saved: Values): boolean {
  let found = 0;
  for (const each of value) if (found < patterns.length && fits(patterns[found] ?? null, each, saved)) found++;
  return found === patterns.length;
}

const operators: Readonly<Record<string, (given: ExactJson, value: ExactJson, saved: Values) => boolean>> = {
  $equals: (given, value, saved) => same(meant(given, saved), value),
  $contains: (given, value, saved) => isList(value) && value.some((each) => fits(given, each, saved)),
  $each: (given, value, saved) => isList(value) && value.length > 0 && value.every((each) => fits(given, each, saved)),
  $ordered: (given, value, saved) => isList(value) && isList(given) && inOrder(given, value, saved),
  $size: (given, value, saved) => isList(value) && value.length === meant(given, saved),
  $matches: (given, value) => typeof value === "string" && typeof given === "string" && new RegExp(given).test(value),
  $least: (given, value) => typeof value === "number" && typeof given === "number" && value >= given,
};

const shown = (value: ExactJson): string => JSON.stringify(value).slice(0, 400);
const isAbsent = (pattern: ExactJson): boolean => isFields(pattern) && pattern["$absent"] === true;

/** Why a value does not fit a pattern, and where; nothing: it does. */
export function mismatch(pattern: ExactJson, value: ExactJson, saved: Values, path = ""): string | undefined {
  if (typeof pattern === "string" && pattern.startsWith("$")) return mismatch({ $equals: pattern }, value, saved, path);
  const [first, second] = isFields(pattern) ? Object.entries(pattern) : [];
  const [name, given] = first !== undefined && second === undefined ? first : ["", null];
  if (name === "$all" && isList(given)) return given.map((each) => mismatch(each, value, saved, path)).find((why) => why !== undefined);
  const operator = operators[name];
  if (operator === undefined && isFields(pattern) && isFields(value)) {
    return Object.entries(pattern).map(([key, wanted]) => mismatchOfField(wanted, key, value, saved, path)).find((why) => why !== undefined);
  }
  if (isList(pattern) && isList(value) && pattern.length === value.length) {
    return pattern.map((wanted, i) => mismatch(wanted, value[i] ?? null, saved, `${path}/${i}`)).find((why) => why !== undefined);
  }
  const holds = operator === undefined ? !isList(pattern) && !isFields(pattern) && same(meant(pattern, saved), value) : operator(given, value, saved);
  return holds ? undefined : `${path === "" ? "/" : path}: ${shown(value)} does not fit ${shown(pattern)}`;
}

function mismatchOfField(pattern: ExactJson, key: string, value: Fields, saved: Values, path: string): string | undefined {
  const found = Object.hasOwn(value, key) ? value[key] : undefined;
  if (isAbsent(pattern)) return found === undefined ? undefined : `${path}/${key} is there`;
  return found === undefined ? `${path}/${key} is not there` : mismatch(pattern, found, saved, `${path}/${key}`);
}
