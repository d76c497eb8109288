// The base class of services, and what their operations throw.
import type { JsonObject, JsonValue } from "../json.js";
import { callerOf, type Place } from "./place.js";

/** Thrown by an operation: the error that answers its call. `code` is what tasks branch on; `more`: further fields. */
export class ServiceFailure extends Error {
  readonly error: JsonObject;
  constructor(code: string, message = "", more: JsonObject = {}) {
    super(message === "" ? code : message);
    this.name = "ServiceFailure";
    this.error = { code, ...(message === "" ? {} : { message }), ...more };
  }
}

/** Thrown by `pause` in an operation whose call is over, and the reason of its signal. End what moves. */
export class Stopped extends Error {
  constructor() {
    super("the call is over");
    this.name = "Stopped";
  }
}

/** Joins a service to the server. */
export interface Host {
  readonly state: string;
  emit(event: string, data: unknown): void;
  take(transition: string): void;
  log(text: string): void;
}

/** Of the library alone. */
export const kHost = Symbol("host");
export const kPlace = Symbol("place");

/**
 * A service: subclasses have a `key`, and fields that are operations (`operation`). Each begins anew in its first state when the server is
 * connected: what they keep is theirs.
 */
export abstract class Service {
  /** As in svc.KEY. */
  abstract readonly key: string;
  /** What kind of service it is; its key, if it says nothing. */
  readonly type?: string;
  /** For people: the RSM has it as `meta.version`. */
  readonly version?: string;
  /** Name -> the type of its data (of RSM), or {"data": TYPE, "sampled": true, ...}. */
  readonly events?: JsonObject;
  /** An RSM, or a file of one (.json) beside this; nothing: it is made of the class. */
  readonly rsm?: JsonObject | string;

  /** What moves must not be faster [m/s], whatever was asked for; undefined: there is no limit. */
  speedLimit: number | undefined;
  [kHost]: Host | undefined;
  readonly [kPlace]: Place | undefined = callerOf(Service);

  /**
   * The server is lost, or silent: nothing may move. A service that does not say what is to be done has its `safe` operations called. It is
   * called further when the server is there again.
   */
  halt?(): unknown;

  /** The present state of the RSM; empty: the service is not connected. */
  get state(): string {
    return this[kHost]?.state ?? "";
  }

  /** Announces an event; without a server, nobody hears of it. Throws a TypeError or a RangeError: the data is no JSON. */
  emit(event: string, data: JsonValue = null): void {
    this[kHost]?.emit(event, data);
  }

  /** Takes a transition of the RSM that no call brings, by its id. Those that answer calls are taken when their work ends. */
  take(transition: string): void {
    this[kHost]?.take(transition);
  }

  /** A line for people in the log of the server. */
  log(text: string): void {
    this[kHost]?.log(text);
  }
}
