// The arguments of a call, held against the parameters of its operation.
import type { JsonObject, JsonValue } from "../json.js";
import type { Parameter } from "./rsm.js";

/** The error that answers a call. */
export type CallError = JsonObject & { readonly code: string };

/** All arguments by name, or why they do not fit. */
export type Bound = { readonly values: JsonObject; readonly error?: undefined } | { readonly values?: undefined; readonly error: CallError };

const kKinds: Readonly<Record<string, (value: JsonValue) => boolean>> = {
  number: (value) => typeof value === "number",
  int: (value) => Number.isInteger(value),
  string: (value) => typeof value === "string",
  bool: (value) => typeof value === "boolean",
};

const invalid = (message: string): { readonly error: CallError } => ({ error: { code: "invalid", message } });

/** Arguments by position and by name; what is not given has the value of its parameter, which is not checked. */
export function bindArguments(parameters: readonly Parameter[], args: readonly JsonValue[], kwargs: JsonObject): Bound {
  if (args.length > parameters.length) return invalid(`there are ${parameters.length} parameters, got ${args.length} arguments`);
  const given = new Map<string, JsonValue>(parameters.slice(0, args.length).map(({ name }, i) => [name, args[i] ?? null]));
  for (const [name, value] of Object.entries(kwargs)) {
    if (!parameters.some((each) => each.name === name)) return invalid(`there is no parameter \`${name}\``);
    if (given.has(name)) return invalid(`\`${name}\` is given twice`);
    given.set(name, value);
  }
  for (const parameter of parameters) {
    const { name, value } = parameter;
    const argument = given.get(name);
    if (argument === undefined && value === undefined) return invalid(`\`${name}\` is missing`);
    const wrong = argument === undefined ? undefined : wrongWith(argument, parameter);
    if (wrong !== undefined) return { error: { ...wrong, argument: name } };
    if (argument === undefined && value !== undefined) given.set(name, value);
  }
  return { values: Object.fromEntries(given) };
}

function wrongWith(value: JsonValue, { name, type, unit, min, max }: Parameter): CallError | undefined {
  const kind = typeof type === "string" ? type : "";
  const isKind = Object.hasOwn(kKinds, kind) ? kKinds[kind] : undefined;
  if (isKind?.(value) === false) return { code: "invalid", message: `\`${name}\` must be of type ${kind}` };
  if (typeof value !== "number" || ((min === undefined || value >= min) && (max === undefined || value <= max))) return undefined;
  const limits = [min === undefined ? [] : [`at least ${min}`], max === undefined ? [] : [`at most ${max}`]].flat().join(" and ");
  return { code: "out_of_range", message: `\`${name}\` must be ${limits}${unit === undefined || unit === "" ? "" : ` ${unit}`}` };
}
