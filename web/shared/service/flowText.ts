// The description of a data flow by the service that offers it.
import type { Rsm } from "../../generated/messages";
import type { JsonValue } from "../json";

const field = (value: JsonValue | undefined, name: string): JsonValue | undefined =>
  typeof value === "object" && value !== null && name in value ? (value as Readonly<Record<string, JsonValue>>)[name] : undefined;

/** `meta.flows` of an RSM may describe its flows by name. `meta` may be any JSON, so anything but a text counts as none. */
export function flowText({ meta }: Rsm, flow: string): string | undefined {
  const text = field(field(meta, "flows"), flow);
  return typeof text === "string" ? text : undefined;
}
