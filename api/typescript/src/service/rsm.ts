// What a service reads of an RSM (api/schemas/service.json); the server checks all of it.
import { isObject, type JsonObject, type JsonValue } from "../json.js";

export interface Parameter {
  readonly name: string;
  readonly type: JsonValue | undefined;
  readonly unit: string | undefined;
  readonly min: number | undefined;
  readonly max: number | undefined;
  /** Of a call that does not give it; nothing: each must. */
  readonly value: JsonValue | undefined;
}

export interface OperationModel {
  readonly name: string;
  readonly parameters: readonly Parameter[];
  readonly isSafe: boolean;
}

export interface Transition {
  readonly id: string;
  readonly dst: string;
  readonly src?: string | undefined;
  readonly operation?: string | undefined;
  readonly defer?: readonly string[] | undefined;
  readonly error?: string | undefined;
  readonly isConcurrent?: boolean | undefined;
}

export interface Rsm {
  readonly operations: readonly OperationModel[];
  /** It has no states: each call is taken. */
  readonly isInterface: boolean;
  /** The first state. */
  readonly init: string;
  readonly transitions: readonly Transition[];
}

const isList = (value: JsonValue): value is readonly JsonValue[] => Array.isArray(value);

/** A field of an RSM, if it is there; throws a TypeError: it is something else. */
function fieldOf<T extends JsonValue>(object: JsonObject, field: string, kind: string, isKind: (value: JsonValue) => value is T): T | undefined {
  const value = object[field];
  if (value === undefined || isKind(value)) return value;
  throw new TypeError(`\`${field}\` of an RSM must be a ${kind}`);
}

const numberOf = (object: JsonObject, field: string) => fieldOf(object, field, "number", (value) => typeof value === "number");
const textOf = (object: JsonObject, field: string) => fieldOf(object, field, "text", (value) => typeof value === "string");
const listOf = (object: JsonObject, field: string) => fieldOf(object, field, "list", isList) ?? [];

function nameOf(object: JsonObject, field: string): string {
  const name = textOf(object, field);
  if (name === undefined) throw new TypeError(`an RSM lacks a \`${field}\``);
  return name;
}

function objectsOf(object: JsonObject, field: string): readonly JsonObject[] {
  return listOf(object, field).map((each) => {
    if (isObject(each)) return each;
    throw new TypeError(`\`${field}\` of an RSM must have objects`);
  });
}

const parameterOf = (object: JsonObject): Parameter => ({
  name: nameOf(object, "name"),
  type: object["type"],
  unit: textOf(object, "unit"),
  min: numberOf(object, "min"),
  max: numberOf(object, "max"),
  value: object["value"],
});

const operationOf = (object: JsonObject): OperationModel => ({
  name: nameOf(object, "name"),
  parameters: objectsOf(object, "parameters").map(parameterOf),
  isSafe: object["safe"] === true,
});

const transitionOf = (object: JsonObject): Transition => ({
  id: nameOf(object, "id"),
  dst: nameOf(object, "dst"),
  src: textOf(object, "src"),
  operation: textOf(object, "operation"),
  defer: listOf(object, "defer").filter((each) => typeof each === "string"),
  error: textOf(object, "error"),
  isConcurrent: object["concurrent"] === true,
});

/** Throws a TypeError: what a service needs of it is none. */
export function readRsm(rsm: JsonObject): Rsm {
  return {
    operations: objectsOf(rsm, "operations").map(operationOf),
    isInterface: listOf(rsm, "states").length === 0,
    init: textOf(rsm, "init") ?? "",
    transitions: objectsOf(rsm, "transitions").map(transitionOf),
  };
}
