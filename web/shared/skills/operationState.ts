// A state that calls one operation of a service, made of what the RSM says of it: its parameters as they are entered, the call, and what comes of it.
import type { RsmOperation, Type } from "../../generated/messages";
import type { KnownService } from "../code/services";
import { kKeywords } from "../code/words";
import type { ExactObject } from "../edit/clipboard/json";
import type { ExactJson } from "../edit/exact";
import type { JsonValue } from "../json";
import { exactNumber } from "../timeline/numbers";

type RsmParameter = NonNullable<RsmOperation["parameters"]>[number];

const kReserved: ReadonlySet<string> = new Set(kKeywords);
/** Whether code can name it: a name may be any of Python's keywords, which the language does not take there, nor names that begin so. */
const isUsable = (name: string): boolean => !kReserved.has(name) && !name.startsWith("__");

/** What a state can call: no stops (`safe`), and nothing that goes on only while a person holds a button. */
const isOffered = (key: string, { name, parameters = [], safe, held }: RsmOperation): boolean =>
  safe !== true && held !== true && [key, name, ...parameters.map((each) => each.name)].every(isUsable);

/** The operations of a service that are offered, in their order. */
export const offeredOperations = ({ key, rsm }: KnownService): readonly RsmOperation[] => rsm.operations.filter((operation) => isOffered(key, operation));

/** A longer text is no hint; an edit has a bound, too. */
const kMostDoc = 1000;
const shortened = (text: string): string => (text.length > kMostDoc ? `${Array.from(text).slice(0, kMostDoc - 1).join("")}…` : text);

/** About a hundredth of the range, as 1, 2 or 5 of a power of ten; nothing for whole numbers and without a range. */
function stepOf({ type, min, max }: RsmParameter): number | undefined {
  if (type === "int" || min === undefined || max === undefined) return undefined;
  const least = (max - min) / 100;
  const ten = 10 ** Math.floor(Math.log10(least));
  const step = Number(([1, 2, 5, 10].map((factor) => factor * ten).find((each) => each >= least) ?? Number.NaN).toPrecision(1));
  return step > 0 && Number.isFinite(step) ? step : undefined;
}

/** What may be absent is null then, as its type allows; all else without a constant is required. */
const constantOf = ({ type, value }: RsmParameter): JsonValue | undefined => (value === undefined && typeof type === "object" && "optional" in type ? null : value);

/** As the document takes it: what is no int stays a float. */
const exactOf = (value: JsonValue, type: Type | undefined): ExactJson => (typeof value === "number" ? exactNumber(value, type !== "number") : value);

function parameterOf(parameter: RsmParameter): ExactObject {
  const { name, type, unit, doc, min, max } = parameter;
  const [value, step] = [constantOf(parameter), stepOf(parameter)];
  const about = { ...(min !== undefined && { min }), ...(max !== undefined && { max }), ...(step !== undefined && { step }) };
  return {
    name, ...(value !== undefined && { value: exactOf(value, type) }), ...(type !== undefined && { type }), ...(unit !== undefined && { unit }), ...(doc !== undefined && { doc: shortened(doc) }),
    ...(Object.keys(about).length > 0 && { meta: about }),
  };
}

/** What went wrong, for who is asked what now (WhatNow takes it by this name). */
const kWhy = "why";

/** A result of the state, and the code that gives it of the answer `r`. */
interface Copied {
  readonly name: string;
  readonly type: Type;
  readonly code: string;
}

/** Whether a record always has this field, and code can read it and write it as a result. */
const isPlain = ([name, type]: readonly [string, Type]): boolean => isUsable(name) && name !== kWhy && !(typeof type === "object" && "optional" in type);

/** The fields of a record that are always there, each as a result; any other answer as one. None, if nobody has said what is answered. */
function copiedOf(type: Type | undefined): readonly Copied[] {
  if (type === undefined || type === "null") return [];
  const fields = typeof type === "object" && "record" in type ? Object.entries(type.record) : undefined;
  if (fields?.every(isPlain) !== true) return [{ name: "result", type, code: "r" }];
  return fields.map(([name, of]) => ({ name, type: of, code: `r["${name}"]` }));
}

/** The stops of a service, for who leaves a motion before it has ended. */
const stopsOf = ({ rsm }: KnownService): readonly string[] =>
  rsm.operations.filter(({ name, safe, parameters = [] }) => safe === true && isUsable(name) && parameters.every((each) => constantOf(each) !== undefined)).map(({ name }) => name);

const inCamelCase = (name: string): string => name.split("_").map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join("");
const kMostName = 64;

/** `my_gripper`, `move_to`: `MyGripperMoveTo`. */
function stateName(key: string, operation: string): string {
  const name = `${inCamelCase(key)}${inCamelCase(operation)}`.slice(0, kMostName);
  return /^[A-Za-z]/.test(name) ? name : `Call${name}`.slice(0, kMostName);
}

const sentence = (text: string): string => (/[.!?…]$/.test(text) ? text : `${text}.`);

function docOf(key: string, { name, doc = "" }: RsmOperation): string {
  const call = `Calls \`${name}\` of the service ${key}.`;
  return doc.trim() === "" ? shortened(call) : `${sentence(shortened(doc.trim()))} ${shortened(call)}`;
}

/**
 * The state, without ids: it has the parameters of the operation, calls it when it is entered, and leaves by `done` when the result is there and copied, or
 * by `error`. Left before, it stops what it has set in motion. Requires an operation of offeredOperations().
 */
export function operationState(service: KnownService, operation: RsmOperation): ExactObject {
  const { key } = service;
  const { parameters = [], result, moves, paces } = operation;
  const call = `svc.${key}.${operation.name}`;
  const copied = copiedOf(result);
  const stops = moves === true && paces !== true ? stopsOf(service) : [];
  const [first] = copied;
  return {
    state: stateName(key, operation.name),
    doc: docOf(key, operation),
    ...(parameters.length > 0 && { parameters: parameters.map(parameterOf) }),
    results: [...copied.map(({ name, type }) => ({ name, type })), { name: kWhy, type: "string", doc: "What went wrong, in the words of the service", meta: { title: "What went wrong" } }],
    entry: `${call}(${parameters.map(({ name }) => `par.${name}`).join(", ")})`,
    ...(stops.length > 0 && { exit: `if not available(${call}.result) and not available(${call}.error):\n${stops.map((stop) => `    svc.${key}.${stop}()`).join("\n")}` }),
    actions: [
      ...(first === undefined ? [] : [{ when: `${call}.result`, do: [`r = ${call}.result`, ...copied.map(({ name, code }) => `res.${name} = ${code}`)].join("\n") }]),
      { when: `${call}.error`, do: `e = ${call}.error\nres.${kWhy} = e.get('message', '${key}: ' + e.code)` },
    ],
    ports: [
      { name: "done", when: first === undefined ? `${call}.result` : `${call}.result and available(res.${first.name})`, meta: { nominal: true, title: "It is done" } },
      { name: "error", when: `${call}.error and available(res.${kWhy})`, meta: { advice: "See what went wrong, then try again.", title: "The service has not done it" } },
    ],
  };
}
