import { describe, expect, it } from "vitest";
import type { Core, CoreDelta } from "../../generated/messages";
import { readStreamMessage, type StreamUpdate } from "../../shared/messages/stream";
import { applyEvent, cellUnavailable, emptySession, watchedCore, type Session } from "../../shared/session/session";
import { applyGesture, firstView, initialView } from "../../shared/session/view";
import { runOf } from "../conformance";

const core: Core = { id: "1", document: "pick", revision: 3, status: "running", paused: false, stepping: false, step: 1, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };
const first = runOf("thesis-pick").steps[0];
if (first === undefined) throw new Error("the recorded run is empty");

const receive = (session: Session, ...updates: readonly StreamUpdate[]): Session => updates.reduce((s, update) => applyEvent(s, { type: "update", update }), session);
const watching = applyEvent(emptySession, { type: "watched", id: "1" });
const running = receive(watching, { type: "state", id: "1", state: { core, state: first.state } });

const delta = (fired: readonly string[], of: Partial<Core> = {}): CoreDelta => ({
  core: { ...core, step: 2, ...of }, active: {}, ports: {}, activated: {}, parameters: {}, results: {}, variables: {},
  unset: { parameters: {}, results: {}, variables: {} }, fired, calls: [],
});

describe("session", () => {
  it("knows that another process of the server answers, until the user has seen it", () => {
    const server = (of: Session, started: number | undefined) => applyEvent(of, { type: "server", cell: true, started });
    const first = server(emptySession, 100);
    expect([first.restarted, server(first, 100).restarted, server(server(first, 200), 200).restarted]).toEqual([false, false, true]);
    expect(applyEvent(server(first, 200), { type: "restart_seen" }).restarted).toBe(false);
    expect(server(server(emptySession, undefined), 100).restarted).toBe(false);
  });
  it("takes state updates of the watched core only", () => {
    expect(watchedCore(running)?.step).toBe(1);
    expect(receive(running, { type: "state_changed", id: "2", delta: delta([]) })).toBe(running);
  });
  it("keeps what the list of cores says of a core whose state comes later, but its counters", () => {
    const refused: Core = { ...core, refused_edit: { revision: 4, errors: [{ path: "", code: "first", message: "names no child" }] } };
    const listed = receive(watching, { type: "cores", cores: [refused] });
    const late: Core = { ...core, step: 9, waiting_edit: { revision: 3, waits: [] } };
    expect(watchedCore(receive(listed, { type: "state", id: "1", state: { core: late, state: first.state } }))).toEqual({ ...refused, step: 9 });
  });
  it("keeps what the watched run asks people, until the page turns to another one", () => {
    const ask = { service: "phone", operation: "ask", args: ["Go on?"], kwargs: {}, call: 4 };
    const asked = receive(running, { type: "state_changed", id: "1", delta: { ...delta([]), calls: [ask] } }, { type: "state_changed", id: "1", delta: delta([]) });
    expect(asked.questions).toEqual([ask]);
    expect(applyEvent(asked, { type: "watched", id: "2" }).questions).toEqual([]);
  });
  it("ignores a delta before the snapshot", () => {
    expect(receive(watching, { type: "state_changed", id: "1", delta: delta(["A.p"]) })).toBe(watching);
  });
  it("counts each step in which a port fires, and no other", () => {
    const once = receive(running, { type: "state_changed", id: "1", delta: delta(["A.p"]) });
    const twice = receive(once, { type: "state_changed", id: "1", delta: delta(["A.p"]) });
    expect([once.fired.fireCount, twice.fired.fireCount]).toEqual([1, 2]);
    expect(receive(twice, { type: "state_changed", id: "1", delta: delta([]) }).fired).toBe(twice.fired);
  });
  it("takes the deltas of a long macro step as one step: each of its ports fires once", () => {
    const states = (...deltas: readonly CoreDelta[]) => deltas.reduce((s, each) => receive(s, { type: "state_changed", id: "1", delta: each }), running).fired;
    const on = { micro: 256 };
    const parts = [delta(["A.p"]), delta([], on), delta(["B.p"], on), delta([], on), delta(["B.p", "C.p"], on), delta([])];
    expect(states(...parts)).toMatchObject({ fireCount: 2, ports: ["B.p", "C.p"] });
    expect(states(...parts, delta(["A.p"]))).toMatchObject({ fireCount: 3, ports: ["A.p"] });
    const lost = parts.slice(0, -1);
    expect(states(...lost, delta(["A.p"], { step: 3 }))).toMatchObject({ fireCount: 3, ports: ["A.p"] });
  });
  it("shows all ports together that fire in the steps of one frame of the page, and each frame once", () => {
    const shown = (...steps: readonly (readonly [frame: number, port: string | undefined])[]) =>
      steps.reduce((s, [frame, port]) => applyEvent(s, { type: "update", update: { type: "state_changed", id: "1", delta: delta(port === undefined ? [] : [port]) }, frame }), running).fired;
    expect(shown([1, "A.p"], [1, undefined], [1, "B.p"], [1, "A.p"])).toMatchObject({ fireCount: 1, ports: ["A.p", "B.p"] });
    expect(shown([1, "A.p"], [2, "A.p"], [2, "C.p"])).toMatchObject({ fireCount: 2, ports: ["A.p", "C.p"] });
    expect(shown([1, "A.p"], [2, undefined], [3, "B.p"])).toMatchObject({ fireCount: 2, ports: ["B.p"] });
  });
  it("takes what is done of a macro step while the core is held as a step", () => {
    const held = (micro: number, port: string) => ({ type: "state_changed", id: "1", delta: delta([port], { micro, paused: true }) }) as const;
    expect(receive(running, held(1, "A.p"), held(2, "B.p")).fired).toMatchObject({ fireCount: 2, ports: ["B.p"] });
  });
  it("keeps the input of a macro step for all its deltas", () => {
    const input = { kind: "event", service: "timer", event: "tick", data: null } as const;
    const parts = [256, 512, 0].map((micro) => ({ type: "state_changed", id: "1", delta: { ...delta([], { micro }), input } }) as const);
    expect(receive(running, ...parts).lastInput).toEqual(input);
  });
  it("keeps the breakpoints of a core", () => {
    const held = { ...core, breakpoints: [{ path: "Root/Pick", when: "entered" }] } as const;
    const message = { channel: "cores", sequence: 1, kind: "delta", data: { core: held } };
    expect(receive(running, readStreamMessage(message).update).cores).toEqual([held]);
  });
  it("reports the cell as unavailable without the server or `robot`, regardless of other services", () => {
    const here = applyEvent(emptySession, { type: "connection", connection: "open" });
    const rsm = { rsm: 1, name: "x", operations: [], events: [] } as const;
    const service = (key: string, available: boolean) => ({ key, type: key, rsm, state: null, available, pending_count: 0, pending: [], violations: [], publishes: [], subscribes: [] });
    const cell = (robot: boolean) => cellUnavailable(receive(here, { type: "services", services: [service("robot", robot), service("db", false)] }));
    expect([cellUnavailable(emptySession), cellUnavailable(here), cell(true), cell(false)]).toEqual(["the server is not there", undefined, undefined, "its process is not there"]);
  });
  it("does not take past derivations of another core", () => {
    expect(applyEvent(running, { type: "past", id: "7", steps: [] })).toBe(running);
  });
  it("forgets the run when another core is watched", () => {
    const other = applyEvent(running, { type: "watched", id: "2" });
    expect([other.run, other.steps.length, other.model]).toEqual([undefined, 0, undefined]);
  });
  it("merges what changed of a service and keeps its model", () => {
    const rsm = { rsm: 1, name: "robot", operations: [], events: [] } as const;
    const idle = { key: "robot", type: "robot", state: "Idle", available: true, pending_count: 0, pending: [], violations: [], publishes: [], subscribes: [], rsm };
    const known = receive(running, { type: "services", services: [idle] });
    const moved = receive(known, { type: "services_changed", services: [{ key: "robot", state: "Moving", available: true, pending_count: 0, pending: [], violations: [], publishes: [], subscribes: [] }] });
    expect(moved.services[0]).toMatchObject({ state: "Moving", rsm });
  });
  it("starts the log anew with a snapshot and goes on with a delta", () => {
    const entry = (text: string) => ({ time: 0, source: "server", text });
    const logged = receive(running, { type: "log", whole: true, entries: [entry("a")] }, { type: "log", whole: false, entries: [entry("b")] });
    expect(logged.log.map((line) => line.text)).toEqual(["a", "b"]);
    expect(receive(logged, { type: "log", whole: true, entries: [entry("c")] }).log.length).toBe(1);
  });
});

describe("view", () => {
  it("opens what hides the target of a jump, and leads back to the task", () => {
    const folded = applyGesture({ ...initialView, page: "services" }, { type: "collapse_all", paths: ["Root/Pick", "Root/Collision"] });
    const jumped = applyGesture(folded, { type: "jump", selection: { kind: "port", address: "Root/Pick/Grasp.success" } });
    expect([...jumped.collapsed]).toEqual(["Root/Collision"]);
    expect([jumped.page, jumped.reveal]).toEqual(["task", 1]);
  });
  it("leaves a focus that does not hold the target", () => {
    const inside = applyGesture(initialView, { type: "enter", path: "Root/Pick" });
    expect(applyGesture(inside, { type: "jump", selection: { kind: "node", path: "Root/Pick/Grasp" } }).focus).toBe("Root/Pick");
    expect(applyGesture(inside, { type: "jump", selection: { kind: "node", path: "Root/Collision" } }).focus).toBeUndefined();
  });
  it("toggles a state, and shows the inside of a state that is entered", () => {
    const folded = applyGesture(initialView, { type: "toggle", path: "Root/Pick" });
    expect([...folded.collapsed]).toEqual(["Root/Pick"]);
    expect([...applyGesture(folded, { type: "toggle", path: "Root/Pick" }).collapsed]).toEqual([]);
    expect([...applyGesture(folded, { type: "enter", path: "Root/Pick" }).collapsed]).toEqual([]);
  });
  it.each([
    [1280, 800, "closed"],
    [1440, 900, "closed"],
    [1600, 1000, "derivation"],
    [412, 915, "derivation"],
  ])("opens in a window of %d by %d with the drawer %s: a low one is for the task", (width, height, drawer) => {
    expect(firstView({ width, height }).drawer).toBe(drawer);
  });
  it("closes the help by Esc first, and clears the selection only then", () => {
    const selection = { kind: "node", path: "Root" } as const;
    const helped = applyGesture({ ...initialView, selection }, { type: "help", shown: true });
    const once = applyGesture(helped, { type: "escape" });
    expect([helped.help, once.help, once.selection]).toEqual([true, false, selection]);
    expect(applyGesture(once, { type: "escape" }).selection).toBeUndefined();
  });
  it("shows the documents over the page, until Esc", () => {
    const shown = applyGesture(initialView, { type: "documents", shown: true });
    expect([shown.documents, applyGesture(shown, { type: "escape" }).documents]).toEqual([true, false]);
  });
  it("keeps the page when another run is watched, but no selection", () => {
    const view = applyGesture({ ...initialView, page: "cell" }, { type: "select", selection: { kind: "node", path: "Root" } });
    expect(applyGesture(view, { type: "forget_run" })).toMatchObject({ page: "cell", selection: undefined });
  });
});
