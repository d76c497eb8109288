// Operations: what a class declares of each, and where.
import type { JsonObject, JsonValue } from "../json.js";
import { callerOf, type Place } from "./place.js";

/** As a parameter stands in the RSM. `value`: of a call that does not give it; without it, each call must. */
export interface ParameterOptions {
  /** "number", "int", "string", "bool", {"record": {...}} and so on. */
  readonly type?: JsonValue;
  readonly unit?: string;
  readonly min?: number;
  readonly max?: number;
  readonly value?: JsonValue;
  readonly doc?: string;
}

/** By name, in the order in which tasks give them. */
export type DeclaredParameters = Readonly<Record<string, ParameterOptions>>;

type ValueOf<T> = T extends "number" | "int" ? number : T extends "string" ? string : T extends "bool" ? boolean : JsonValue;
export type ArgumentsOf<P> = { readonly [K in keyof P]: P[K] extends { readonly type: infer T } ? ValueOf<T> : JsonValue };

/** A call while it is at work. */
export interface RunningCall {
  /** Aborted, with Stopped as its reason, when the call is over: another operation has stopped it, or the server is lost. End what moves. */
  readonly signal: AbortSignal;
  /** Waits for so many seconds. Rejects with Stopped when the call is over. */
  readonly pause: (seconds: number) => Promise<void>;
}

/** What it returns, or resolves to, is the result. */
export type Work<A> = (args: A, call: RunningCall) => unknown;

export interface OperationOptions<P = DeclaredParameters> {
  /** It may set something in the cell in motion. */
  readonly moves?: boolean;
  /** It stops what is in motion; called without arguments, also when the cell is stopped. */
  readonly safe?: boolean;
  /** It changes nothing. */
  readonly reads?: boolean;
  /** A state in which the service is until the work is done, and in which it takes this operation, and others that are `busy`, not again. */
  readonly busy?: string;
  /** A state of another one that is `busy`: that ends with the error `stopped`. */
  readonly stops?: string;
  readonly parameters?: P;
  /** The type of its result. */
  readonly result?: JsonValue;
  /** For people. */
  readonly doc?: string;
}

/** An operation of a service, as `operation` makes it. */
export class Operation {
  constructor(
    readonly options: OperationOptions,
    readonly work: Work<JsonObject>,
    readonly place: Place | undefined,
  ) {}

  /** As it stands in an RSM. */
  model(name: string): JsonObject & { readonly name: string } {
    const { parameters = {}, result, doc, ...options } = this.options;
    const listed = Object.entries(parameters).map(([parameter, more]) => ({ name: parameter, ...more }) as JsonObject);
    const flags = (["moves", "safe", "reads"] as const).filter((flag) => options[flag] === true).map((flag) => [flag, true] as const);
    return {
      name,
      ...(listed.length === 0 ? {} : { parameters: listed }),
      ...(result === undefined ? {} : { result }),
      error: "any",
      ...Object.fromEntries(flags),
      ...(doc === undefined ? {} : { doc }),
    };
  }
}

/**
 * Makes a field of a service an operation: tasks call it by the name of the field, with arguments by position or name, and `work` gets
 * them by name. The options are for an RSM that is made of the class; the line of this call is where violations are shown.
 */
export function operation(work: Work<JsonObject>): Operation;
export function operation<const P extends DeclaredParameters>(options: OperationOptions<P>, work: Work<ArgumentsOf<P>>): Operation;
export function operation(first: OperationOptions | Work<never>, second?: Work<never>): Operation {
  const options: OperationOptions = typeof first === "function" ? {} : first;
  const work = typeof first === "function" ? first : second;
  if (typeof work !== "function") throw new TypeError("an operation needs a function");
  return new Operation(options, work as Work<JsonObject>, callerOf(operation));
}
