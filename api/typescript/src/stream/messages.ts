// Messages of the stream (api/schemas/stream_message.json): what a channel says, as one union.
import type {
  AcceptedEdit,
  CellPose,
  Control,
  Core,
  CoreDelta,
  CoreState,
  Display,
  DocumentSnapshot,
  EditRefusal,
  Envelope,
  HostedService,
  LogEntry,
  Packet,
  PresenceDelta,
  PresenceJoined,
  PresenceSnapshot,
  Proposal,
  ServerError,
  ServiceState,
  TraceStep,
} from "../generated/messages.js";
import * as schema from "../generated/validators.js";
import { check, SchemaError } from "../check.js";

/** What a message of the stream means. */
export type StreamUpdate =
  | { readonly type: "cores"; readonly cores: readonly Core[] }
  | { readonly type: "core"; readonly core: Core }
  | { readonly type: "core_removed"; readonly id: string }
  | { readonly type: "state"; readonly id: string; readonly state: CoreState }
  | { readonly type: "state_changed"; readonly id: string; readonly delta: CoreDelta }
  | { readonly type: "derivation_position"; readonly id: string; readonly next: number }
  | { readonly type: "derivations"; readonly id: string; readonly steps: readonly TraceStep[] }
  | { readonly type: "services"; readonly services: readonly HostedService[] }
  | { readonly type: "services_changed"; readonly services: readonly ServiceState[] }
  | { readonly type: "cell"; readonly pose: CellPose }
  | { readonly type: "control"; readonly control: Control }
  | { readonly type: "display"; readonly content: Display }
  | { readonly type: "packet"; readonly channel: string; readonly packet: Packet }
  | { readonly type: "document"; readonly snapshot: DocumentSnapshot }
  | { readonly type: "document_edited"; readonly edit: AcceptedEdit }
  | { readonly type: "edit_accepted"; readonly edit: AcceptedEdit }
  | { readonly type: "edit_refused"; readonly refusal: EditRefusal }
  | { readonly type: "people"; readonly channel: string; readonly people: PresenceSnapshot }
  | { readonly type: "people_changed"; readonly channel: string; readonly change: PresenceDelta }
  | { readonly type: "joined"; readonly joined: PresenceJoined }
  | { readonly type: "proposals"; readonly proposals: readonly Proposal[]; readonly whole: boolean }
  | { readonly type: "log"; readonly entries: readonly LogEntry[]; readonly whole: boolean }
  | { readonly type: "refused"; readonly channel: string; readonly errors: readonly ServerError[] };

export interface StreamMessage {
  readonly channel: string;
  /** None of a message to this client alone. */
  readonly sequence: number | undefined;
  readonly update: StreamUpdate;
}

function coreUpdate(id: string, subject: string, snapshot: boolean, data: unknown): StreamUpdate {
  if (subject === "state") {
    if (snapshot) return { type: "state", id, state: check(schema.coreState, data, "/data") };
    return { type: "state_changed", id, delta: check(schema.coreDelta, data, "/data") };
  }
  if (snapshot) return { type: "derivation_position", id, next: check(schema.derivationPosition, data, "/data").next };
  return { type: "derivations", id, steps: check(schema.derivationSteps, data, "/data").steps };
}

function coresUpdate(snapshot: boolean, data: unknown): StreamUpdate {
  if (snapshot) return { type: "cores", cores: check(schema.cores, data, "/data").cores };
  const change = check(schema.coresDelta, data, "/data");
  return "removed" in change ? { type: "core_removed", id: change.removed } : { type: "core", core: change.core };
}

function servicesUpdate(snapshot: boolean, data: unknown): StreamUpdate {
  if (snapshot) return { type: "services", services: check(schema.services, data, "/data").services };
  return { type: "services_changed", services: check(schema.servicesDelta, data, "/data").services };
}

function documentUpdate(snapshot: boolean, data: unknown): StreamUpdate {
  if (snapshot) return { type: "document", snapshot: check(schema.documentSnapshot, data, "/data") };
  return { type: "document_edited", edit: check(schema.acceptedEdit, data, "/data") };
}

function presenceUpdate(channel: string, snapshot: boolean, data: unknown): StreamUpdate {
  if (snapshot) return { type: "people", channel, people: check(schema.presenceSnapshot, data, "/data") };
  return { type: "people_changed", channel, change: check(schema.presenceDelta, data, "/data") };
}

function updateOf({ channel, kind, data }: Envelope): StreamUpdate {
  if (kind === "error") return { type: "refused", channel, errors: check(schema.errors, data, "/data").errors };
  if (kind === "edit_accepted") return { type: kind, edit: check(schema.acceptedEdit, data, "/data") };
  if (kind === "edit_refused") return { type: kind, refusal: check(schema.editRefusal, data, "/data") };
  if (kind === "joined") return { type: kind, joined: check(schema.presenceJoined, data, "/data") };
  const snapshot = kind === "snapshot";
  if (channel.startsWith("document/")) return documentUpdate(snapshot, data);
  if (channel.startsWith("presence/")) return presenceUpdate(channel, snapshot, data);
  const [, id, subject] = /^core\/([^/]+)\/(state|derivation)$/.exec(channel) ?? [];
  if (id !== undefined && subject !== undefined) return coreUpdate(id, subject, snapshot, data);
  if (channel.startsWith("flow/")) return { type: "packet", channel, packet: check(schema.packet, data, "/data") };
  if (channel.startsWith("display/")) return { type: "display", content: check(schema.display, data, "/data") };
  switch (channel) {
    case "cores":
      return coresUpdate(snapshot, data);
    case "services":
      return servicesUpdate(snapshot, data);
    case "control":
      return { type: "control", control: check(schema.control, data, "/data") };
    case "cell/pose":
      return { type: "cell", pose: check(schema.cellPose, data, "/data") };
    case "proposals":
      return { type: "proposals", proposals: check(schema.proposals, data, "/data").proposals, whole: snapshot };
    case "log":
      return { type: "log", entries: check(schema.logEntries, data, "/data").entries, whole: snapshot };
    default:
      throw new SchemaError("/channel", "a channel of stream_message.json", channel);
  }
}

export function readStreamMessage(value: unknown): StreamMessage {
  const message = check(schema.envelope, value);
  const isPrivate = message.kind === "edit_accepted" || message.kind === "edit_refused" || message.kind === "joined";
  return { channel: message.channel, sequence: isPrivate ? undefined : message.sequence, update: updateOf(message) };
}
