// The input of a macro step, and a call, in one line each.
import type { Call, Force, Input } from "../../generated/messages";
import { clip, valueText } from "../model/describe";

export function inputText(input: Input): string {
  switch (input.kind) {
    case "event":
      return `event ${input.service}.${input.event}${input.data === null ? "" : ` ${clip(valueText(input.data), 60)}`}`;
    case "response":
      return `response ${input.service}.${input.operation} ${
        input.error === undefined ? `→ ${clip(valueText(input.result ?? null), 60)}` : `✕ ${clip(valueText(input.error), 60)}`
      }`;
    case "edit":
      return input.revision === undefined ? "edit" : `edit: revision ${input.revision}`;
    case "force":
      return `force ${forceText(input.force)}`;
    default:
      return input.kind;
  }
}

function forceText({ path, scope, name, value }: Force): string {
  return scope === "port" ? `${path}.${name}` : `${path} ${scope}.${name} = ${clip(valueText(value ?? null), 60)}`;
}

export function callText(call: Call): string {
  const keywords = Object.entries(call.kwargs).map(([name, value]) => `${name}=${valueText(value)}`);
  return `${call.service}.${call.operation}(${[...call.args.map(valueText), ...keywords].join(", ")})`;
}
