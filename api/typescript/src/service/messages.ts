// What the server says to a process of services (api/schemas/component_message.json), as far as services of one's own need it.
import { failure, kProtocol } from "../errors.js";
import type { ServerError } from "../generated/messages.js";
import { isObject, type JsonObject, type JsonValue } from "../json.js";

export interface CallMessage {
  readonly type: "call";
  readonly key: string;
  readonly call: number;
  readonly operation: string;
  readonly args: readonly JsonValue[];
  readonly kwargs: JsonObject;
}

export interface ViolationMessage {
  readonly type: "violation";
  readonly key: string;
  readonly rule: string;
  readonly message: string;
  /** 0: none. */
  readonly call: number;
  readonly operation: string;
}

export interface SpeedMessage {
  readonly type: "limit_speed";
  readonly key: string;
  /** [m/s]; undefined: there is no limit. */
  readonly speed: number | undefined;
}

/** Of one service. */
export type ServiceMessage = CallMessage | ViolationMessage | SpeedMessage;

export type ServerMessage =
  | ServiceMessage
  | { readonly type: "welcome"; /** [s] */ readonly heartbeat: number }
  | { readonly type: "refused"; readonly errors: readonly ServerError[] }
  | { readonly type: "ping"; readonly number: number }
  /** What these services did not ask for, or a newer server says. */
  | { readonly type: "other" };

/** [ms] of a server that does not say it. */
const kHeartbeat = 1000;

function textOf(message: JsonObject, field: string): string {
  const value = message[field];
  if (typeof value !== "string") throw new TypeError(field);
  return value;
}

function numberOf(message: JsonObject, field: string, otherwise?: number): number {
  const value = message[field] ?? otherwise;
  if (typeof value !== "number") throw new TypeError(field);
  return value;
}

function listOf(message: JsonObject, field: string): readonly JsonValue[] {
  const value = message[field];
  if (!Array.isArray(value)) throw new TypeError(field);
  return value as readonly JsonValue[];
}

function objectOf(value: JsonValue | undefined): JsonObject {
  if (!isObject(value)) throw new TypeError("object");
  return value;
}

const errorOf = (value: JsonValue): ServerError => {
  const error = objectOf(value);
  return { path: textOf(error, "path"), code: textOf(error, "code"), message: textOf(error, "message") };
};

function messageOf(message: JsonObject): ServerMessage {
  switch (textOf(message, "type")) {
    case "welcome":
      return { type: "welcome", heartbeat: numberOf(message, "heartbeat", kHeartbeat) / 1000 };
    case "refused":
      return { type: "refused", errors: listOf(message, "errors").map(errorOf) };
    case "ping":
      return { type: "ping", number: numberOf(message, "number") };
    case "call": {
      const [args, kwargs] = [listOf(message, "args"), objectOf(message["kwargs"])];
      return { type: "call", key: textOf(message, "key"), call: numberOf(message, "call"), operation: textOf(message, "operation"), args, kwargs };
    }
    case "violation": {
      const [rule, said] = [textOf(message, "rule"), textOf(message, "message")];
      return { type: "violation", key: textOf(message, "key"), rule, message: said, call: numberOf(message, "call"), operation: textOf(message, "operation") };
    }
    case "limit_speed": {
      const speed = message["tool_speed"] === null ? undefined : numberOf(message, "tool_speed");
      return { type: "limit_speed", key: textOf(message, "key"), speed };
    }
    default:
      return { type: "other" };
  }
}

/** A message as it came; binary ones (packets) are not for these services. Throws a RaceError `protocol`: it is none. */
export function readMessage(data: unknown): ServerMessage {
  if (typeof data !== "string") return { type: "other" };
  try {
    return messageOf(objectOf(JSON.parse(data) as JsonValue));
  } catch {
    throw failure(kProtocol, `this is no message of the server: ${data.slice(0, 200)}`);
  }
}
