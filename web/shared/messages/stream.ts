// Messages of the stream (api/schemas: stream_message, stream_request): what a channel says, as one union.
import { array, number, object, oneOf, string, type Decoder } from "../json/decode";
import { cellPose, type CellPose } from "./cell";
import { core, cores, coreDelta, coreState, type Core, type CoreDelta, type CoreState } from "./core";
import { traceSteps, type TraceStep } from "./derivation";
import { content, type Content, type DisplayRequest } from "./display";
import { packet, type Packet } from "./packet";
import { services, serviceStates, type Service, type ServiceState } from "./service";

export interface LogEntry {
  /** [s] */
  readonly time: number;
  readonly source: string;
  readonly text: string;
}

export interface ServerError {
  readonly path: string;
  readonly code: string;
  readonly message: string;
}

/** What a message of the stream means. */
export type News =
  | { readonly type: "cores"; readonly cores: readonly Core[] }
  | { readonly type: "core"; readonly core: Core }
  | { readonly type: "core_removed"; readonly id: string }
  | { readonly type: "state"; readonly id: string; readonly state: CoreState }
  | { readonly type: "state_changed"; readonly id: string; readonly delta: CoreDelta }
  | { readonly type: "derivation_position"; readonly id: string; readonly next: number }
  | { readonly type: "derivations"; readonly id: string; readonly steps: readonly TraceStep[] }
  | { readonly type: "services"; readonly services: readonly Service[] }
  | { readonly type: "services_changed"; readonly services: readonly ServiceState[] }
  | { readonly type: "cell"; readonly pose: CellPose }
  | { readonly type: "display"; readonly content: Content }
  | { readonly type: "packet"; readonly channel: string; readonly packet: Packet }
  | { readonly type: "log"; readonly entries: readonly LogEntry[]; readonly whole: boolean }
  | { readonly type: "refused"; readonly channel: string; readonly errors: readonly ServerError[] };

export interface StreamMessage {
  readonly channel: string;
  readonly sequence: number;
  readonly news: News;
}

export type StreamRequest =
  | { readonly type: "subscribe"; readonly channel: string; readonly since?: number }
  | { readonly type: "unsubscribe"; readonly channel: string }
  | DisplayRequest;

const logEntry: Decoder<LogEntry> = object((f) => ({
  time: f.need("time", number),
  source: f.need("source", string),
  text: f.need("text", string),
}));

const serverError: Decoder<ServerError> = object((f) => ({
  path: f.need("path", string),
  code: f.need("code", string),
  message: f.need("message", string),
}));

export const serverErrors: Decoder<readonly ServerError[]> = object((f) => f.need("errors", array(serverError)));
const logEntries: Decoder<readonly LogEntry[]> = object((f) => f.need("entries", array(logEntry)));

const coresChanged: Decoder<News> = object((f) =>
  f.has("removed") ? { type: "core_removed", id: f.need("removed", string) } : { type: "core", core: f.need("core", core) },
);

type Kind = "snapshot" | "delta" | "error";

function newsOf(channel: string, kind: Kind): Decoder<News> {
  const snapshot = kind === "snapshot";
  const core = /^core\/([^/]+)\/(state|derivation)$/.exec(channel);
  const id = core?.[1] ?? "";
  if (kind === "error") return (v, p) => ({ type: "refused", channel, errors: serverErrors(v, p) });
  if (core?.[2] === "state") {
    if (snapshot) return (v, p) => ({ type: "state", id, state: coreState(v, p) });
    return (v, p) => ({ type: "state_changed", id, delta: coreDelta(v, p) });
  }
  if (core?.[2] === "derivation") {
    if (snapshot) return object((f) => ({ type: "derivation_position" as const, id, next: f.need("next", number) }));
    return (v, p) => ({ type: "derivations", id, steps: traceSteps(v, p) });
  }
  if (channel.startsWith("flow/")) return (v, p) => ({ type: "packet", channel, packet: packet(v, p) });
  if (channel.startsWith("display/")) return (v, p) => ({ type: "display", content: content(v, p) });
  const whole: Decoder<string> = oneOf("cores", "services", "cell/pose", "log");
  switch (whole(channel, "/channel")) {
    case "cores":
      return snapshot ? (v, p) => ({ type: "cores", cores: cores(v, p) }) : coresChanged;
    case "services":
      if (snapshot) return (v, p) => ({ type: "services", services: services(v, p) });
      return (v, p) => ({ type: "services_changed", services: serviceStates(v, p) });
    case "cell/pose":
      return (v, p) => ({ type: "cell", pose: cellPose(v, p) });
    default:
      return (v, p) => ({ type: "log", entries: logEntries(v, p), whole: snapshot });
  }
}

export const streamMessage: Decoder<StreamMessage> = object((f) => {
  const channel = f.need("channel", string);
  const kind = f.need("kind", oneOf("snapshot", "delta", "error"));
  return { channel, sequence: f.need("sequence", number), news: f.need("data", newsOf(channel, kind)) };
});
