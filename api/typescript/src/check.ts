// The check of what comes from outside: it is `unknown` until the validator of its schema accepts it.

/** One way in which a value breaks its schema, as ajv reports it. */
export interface Violation {
  /** JSON pointer. */
  readonly instancePath: string;
  readonly keyword: string;
  readonly params: Readonly<Record<string, unknown>>;
}

/** Made from a schema of `api` (web/generate). `errors` belongs to the last call. */
export interface Validator<T> {
  (value: unknown): value is T;
  readonly errors?: readonly Violation[] | null;
}

/** A message that breaks its schema: what was expected, and where. */
export class SchemaError extends Error {
  constructor(
    /** JSON pointer. */
    readonly path: string,
    readonly expected: string,
    got: unknown,
  ) {
    super(`${path === "" ? "/" : path}: expected ${expected}, got ${kindOf(got)}`);
    this.name = "SchemaError";
  }
}

function kindOf(value: unknown): string {
  if (value === null) return "null";
  return Array.isArray(value) ? "array" : typeof value;
}

/** The field that a violation is about, also one that is missing. */
function fieldOf({ instancePath, keyword, params }: Violation): string {
  const field = keyword === "required" ? params["missingProperty"] : keyword === "discriminator" ? params["tag"] : undefined;
  return field === undefined ? instancePath : `${instancePath}/${textOf(field)}`;
}

const textOf = (value: unknown): string => (typeof value === "string" ? value : JSON.stringify(value));

function expectation({ keyword, params }: Violation): string {
  switch (keyword) {
    case "type":
      return [params["type"]].flat().map(textOf).join(" or ");
    case "required":
      return "a value";
    case "enum":
      return [params["allowedValues"]].flat().map((value) => JSON.stringify(value)).join(" | ");
    case "const":
      return JSON.stringify(params["allowedValue"]);
    case "discriminator":
      return "a known kind";
    default:
      return `${keyword} ${textOf(params["limit"] ?? params["pattern"] ?? "")}`.trim();
  }
}

const depth = (path: string): number => path.split("/").length;

function valueAt(value: unknown, path: string): unknown {
  const keys = path.split("/").slice(1).map((key) => key.replaceAll("~1", "/").replaceAll("~0", "~"));
  return keys.reduce<unknown>((at, key) => (typeof at === "object" && at !== null ? (at as Readonly<Record<string, unknown>>)[key] : undefined), value);
}

/** Of alternatives that all fail, the error names those that the value has most in common with: they fail deepest. */
function errorOf(violations: readonly Violation[], value: unknown, path: string): SchemaError {
  const deepest = Math.max(...violations.map((each) => depth(fieldOf(each))));
  const field = violations.map(fieldOf).find((each) => depth(each) === deepest) ?? "";
  const expected = violations.filter((each) => fieldOf(each) === field && each.keyword !== "oneOf" && each.keyword !== "anyOf").map(expectation);
  return new SchemaError(path + field, [...new Set(expected)].join(" | "), valueAt(value, field));
}

/** The value, found at `path` (JSON pointer) of a message, if it has the shape of its schema. Throws SchemaError. */
export function check<T>(validator: Validator<T>, value: unknown, path = ""): T {
  if (validator(value)) return value;
  throw errorOf(validator.errors ?? [], value, path);
}
