// Of a run that goes on by itself its steps may be shown late, and nothing else of it.
import { describe, expect, it } from "vitest";
import type { Core, CoreDelta, HostedService, PendingCall, TraceStep } from "../../generated/messages";
import type { StreamUpdate } from "../../shared/messages/stream";
import { applyEvent, emptySession, type Session, type SessionEvent } from "../../shared/session/session";
import { isUrgent } from "../../shared/session/urgent";
import { runOf } from "../conformance";

const core: Core = { id: "1", document: "pick", revision: 3, status: "running", paused: false, stepping: false, step: 1, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };
const first = runOf("thesis-pick").steps[0];
if (first === undefined) throw new Error("the recorded run is empty");

const derivation: TraceStep = { step: 2, input: { kind: "start" }, micro: [], calls: [] };
const ask: PendingCall = { call: 7, operation: "ask", time: 1, core: "1" };
const display: HostedService = { key: "display", type: "display", state: null, available: true, pending_count: 0, pending: [], violations: [], rsm: { rsm: 1, name: "display", operations: [], events: [] }, publishes: [], subscribes: [] };

const update = (update: StreamUpdate): SessionEvent => ({ type: "update", update });
const after = (session: Session, ...events: readonly SessionEvent[]): Session => events.reduce(applyEvent, session);
const delta = (of: Partial<Core>): CoreDelta => ({
  core: { ...core, arguments: {}, breakpoints: [], ...of }, active: { A: true }, ports: {}, activated: {}, parameters: {}, results: {}, variables: {},
  unset: { parameters: {}, results: {}, variables: {} }, fired: ["A.p"], calls: [],
});
const stepped = (of: Partial<Core>): SessionEvent => update({ type: "state_changed", id: "1", delta: delta(of) });
const other: Core = { ...core, id: "2" };

const running = after(emptySession, { type: "watched", id: "1" }, update({ type: "cores", cores: [core, other] }), update({ type: "services", services: [display] }), update({ type: "state", id: "1", state: { core, state: first.state } }));
const paused = after(running, stepped({ paused: true }));

const urgent = (before: Session, ...events: readonly SessionEvent[]): boolean => isUrgent(before, after(before, ...events));

describe("what is urgent", () => {
  it("are no steps of a run that goes on, their derivations, calls and lines of the log", () => {
    expect(urgent(running, stepped({ step: 2 }), stepped({ step: 3, micro: 4, waiting: 5 }))).toBe(false);
    expect(urgent(running, update({ type: "derivations", id: "1", steps: [derivation] }))).toBe(false);
    expect(urgent(running, update({ type: "core", core: { ...other, step: 5 } }))).toBe(false);
    expect(urgent(running, update({ type: "services_changed", services: [{ ...display, state: "Busy", pending_count: 1, pending: [{ ...ask, operation: "show_text" }] }] }))).toBe(false);
    expect(urgent(paused, update({ type: "log", entries: [{ time: 1, source: "core", text: "said" }], whole: false }))).toBe(false);
  });
  it.each<[string, Partial<Core>]>([
    ["a pause", { paused: true }],
    ["its end", { status: "ended", outcome: "done", results: {} }],
    ["a fault", { status: "faulted", fault: { at: "A", kind: "zero_division", message: "division by zero" } }],
    ["an interruption", { status: "interrupted", paused: true, interruption: { reason: "overload", message: "too much" } }],
    ["a breakpoint that was set", { breakpoints: [{ when: "entered", path: "A" }] }],
    ["an edit that waits", { waiting_edit: { revision: 4, waits: [] } }],
    ["another model", { model: 2 }],
  ])("is %s, with steps or without", (_, of) => {
    expect(urgent(running, stepped({ step: 2 }), stepped({ step: 3, ...of }))).toBe(true);
    expect(urgent(running, update({ type: "core", core: { ...core, ...of } }))).toBe(true);
  });
  it("is each step of a run that is paused, and its derivation", () => {
    expect(urgent(paused, stepped({ paused: true, step: 2 }))).toBe(true);
    expect(urgent(paused, update({ type: "derivations", id: "1", steps: [derivation] }))).toBe(true);
  });
  it("is a question to a person, its answer, and a service that is lost", () => {
    const asked = after(running, update({ type: "services_changed", services: [{ ...display, pending: [ask] }] }));
    expect(isUrgent(running, asked)).toBe(true);
    expect(urgent(asked, update({ type: "services_changed", services: [{ ...display, pending: [] }] }))).toBe(true);
    expect(urgent(running, update({ type: "services_changed", services: [{ ...display, available: false }] }))).toBe(true);
  });
  it("is a run that comes, goes or ends besides the watched one, and what the page turns to", () => {
    expect(urgent(running, update({ type: "core_removed", id: "2" }))).toBe(true);
    expect(urgent(running, update({ type: "core", core: { ...other, status: "ended" } }))).toBe(true);
    expect(urgent(running, { type: "watched", id: "2" })).toBe(true);
    expect(urgent(running, { type: "connection", connection: "lost" })).toBe(true);
    expect(urgent(running, { type: "problem", text: "refused" })).toBe(true);
  });
});
