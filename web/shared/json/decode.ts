// Parsing of `unknown` at the door: small decoders that either give a typed value or say where it went wrong.

/** Any JSON value, as it stands in results, parameters and event data. */
export type JsonValue = null | boolean | number | string | readonly JsonValue[] | { readonly [key: string]: JsonValue };

/** Reads a value of type T found at `path` (JSON pointer); throws DecodeError. */
export type Decoder<T> = (value: unknown, path: string) => T;

/** What was expected, and where, in a message that does not have the agreed shape. */
export class DecodeError extends Error {
  constructor(
    readonly path: string,
    readonly expected: string,
    got: unknown,
  ) {
    super(`${path === "" ? "/" : path}: expected ${expected}, got ${kindOf(got)}`);
    this.name = "DecodeError";
  }
}

function kindOf(value: unknown): string {
  if (value === null) return "null";
  return Array.isArray(value) ? "array" : typeof value;
}

function isRecord(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

export const string: Decoder<string> = (value, path) => {
  if (typeof value !== "string") throw new DecodeError(path, "string", value);
  return value;
};

export const number: Decoder<number> = (value, path) => {
  if (typeof value !== "number") throw new DecodeError(path, "number", value);
  return value;
};

export const boolean: Decoder<boolean> = (value, path) => {
  if (typeof value !== "boolean") throw new DecodeError(path, "boolean", value);
  return value;
};

export const json: Decoder<JsonValue> = (value, path) => {
  if (value === null || typeof value === "string" || typeof value === "boolean" || typeof value === "number") return value;
  if (Array.isArray(value)) return value.map((item, i) => json(item, `${path}/${i}`));
  if (isRecord(value)) return record(json)(value, path);
  throw new DecodeError(path, "JSON value", value);
};

export function array<T>(item: Decoder<T>): Decoder<readonly T[]> {
  return (value, path) => {
    if (!Array.isArray(value)) throw new DecodeError(path, "array", value);
    return value.map((entry: unknown, i) => item(entry, `${path}/${i}`));
  };
}

export function record<T>(item: Decoder<T>): Decoder<Readonly<Record<string, T>>> {
  return (value, path) => {
    if (!isRecord(value)) throw new DecodeError(path, "object", value);
    return Object.fromEntries(Object.entries(value).map(([key, entry]) => [key, item(entry, `${path}/${key}`)]));
  };
}

export function oneOf<const T extends string>(...allowed: readonly T[]): Decoder<T> {
  return (value, path) => {
    const found = allowed.find((entry) => entry === value);
    if (found === undefined) throw new DecodeError(path, allowed.map((entry) => `"${entry}"`).join(" | "), value);
    return found;
  };
}

/** The fields of one object: `need` throws where a field is missing, `maybe` gives undefined, `or` a default. */
export interface Fields {
  need<T>(name: string, decoder: Decoder<T>): T;
  maybe<T>(name: string, decoder: Decoder<T>): T | undefined;
  or<T>(name: string, decoder: Decoder<T>, fallback: T): T;
  has(name: string): boolean;
}

export function object<T>(read: (fields: Fields) => T): Decoder<T> {
  return (value, path) => {
    if (!isRecord(value)) throw new DecodeError(path, "object", value);
    const maybe = <V>(name: string, decoder: Decoder<V>): V | undefined => {
      const field = value[name];
      return field === undefined ? undefined : decoder(field, `${path}/${name}`);
    };
    return read({
      maybe,
      need: (name, decoder) => decoder(value[name], `${path}/${name}`),
      or: (name, decoder, fallback) => maybe(name, decoder) ?? fallback,
      has: (name) => name in value,
    });
  };
}

/** Leaves out the fields that are undefined, as optional properties demand. */
export function present<T extends object>(fields: { [K in keyof T]: T[K] | undefined }): T {
  return Object.fromEntries(Object.entries(fields).filter(([, value]) => value !== undefined)) as T;
}
