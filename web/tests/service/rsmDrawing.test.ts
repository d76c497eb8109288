import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import type { Rsm } from "../../generated/messages";
import { drawRsm, labelLines } from "../../shared/service/rsmDrawing";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;

/** Fig. 4.1: the simplified robot service. */
const robot: Rsm = {
  rsm: 1,
  name: "robot",
  operations: [{ name: "move" }, { name: "stop", safe: true }],
  events: [{ name: "robot_state", sampled: true }],
  states: [{ name: "Idle" }, { name: "Moving" }],
  init: "Idle",
  transitions: [
    { id: "start", src: "Idle", dst: "Moving", operation: "move", defer: ["arrive"] },
    { id: "arrive", src: "Moving", dst: "Idle" },
    { id: "stop", dst: "Idle", operation: "stop", error: "aborted" },
  ],
};

describe("drawRsm", async () => {
  const drawing = await drawRsm(engine, robot);
  it("shows the states, the start, and a source for transitions from every state", () => {
    expect(drawing.states.map((state) => `${state.kind} ${state.name}`).sort()).toEqual(["any any state", "init #init", "state Idle", "state Moving"]);
    expect(drawing.start.length).toBeGreaterThan(1);
  });
  it("starts a transition without source at `any state`, and the others at theirs", () => {
    const sources = drawing.arrows.map((arrow) => {
      const from = arrow.points[0];
      return drawing.states.find((s) => from !== undefined && Math.abs(from.x - s.x - s.width / 2) <= s.width / 2 + 1 && Math.abs(from.y - s.y - s.height / 2) <= s.height / 2 + 1)?.name;
    });
    expect(sources).toEqual(["Idle", "Moving", "any state"]);
  });
  it("labels a transition with its operation and marks spontaneous ones", () => {
    expect(drawing.arrows.map((arrow) => [arrow.label.text, arrow.label.spontaneous])).toEqual([
      ["move", false],
      ["arrive", true],
      ["stop / aborted", false],
    ]);
  });
  it("merges loops of a stateless service into one arrow", async () => {
    const loops = ["get", "add"].map((name) => ({ id: name, src: "Ready", dst: "Ready", operation: name }));
    const stateless: Rsm = { rsm: 1, name: "db", operations: [{ name: "get" }, { name: "add" }], events: [], states: [{ name: "Ready" }], transitions: loops };
    const arrows = (await drawRsm(engine, stateless)).arrows;
    expect(arrows.map((arrow) => [arrow.label.text, arrow.transitions])).toEqual([["get, add", ["get", "add"]]]);
    const anywhere = { ...stateless, transitions: loops.map(({ src: _, ...rest }) => rest) };
    expect((await drawRsm(engine, anywhere)).arrows.map((arrow) => arrow.label.text)).toEqual(["get, add"]);
  });
  it("links a deferred call with the transition that answers it", () => {
    expect(drawing.deferrals.map((link) => link.id)).toEqual(["start:arrive"]);
  });
});

describe("a service that answers several operations in several ways", async () => {
  const answers = ["answered", "refused", "replaced"];
  const asks = ["ask", "choose", "ask_number"].map((operation) => ({ id: operation, src: "Idle", dst: "Asking", operation, defer: answers }));
  const display: Rsm = {
    rsm: 1, name: "display", operations: asks.map(({ operation }) => ({ name: operation })), events: [], states: [{ name: "Idle" }, { name: "Asking" }], init: "Idle",
    transitions: [...asks, ...answers.map((id) => ({ id, src: "Asking", dst: "Idle" }))],
  };
  const { arrows, deferrals } = await drawRsm(engine, display);
  it("has an arrow for operations that are answered alike, with one dashed line to each answer", () => {
    expect(arrows.map(({ label, transitions }) => [label.text, transitions.length])).toEqual([["ask, choose, ask_number", 3], ["answered", 1], ["refused", 1], ["replaced", 1]]);
    expect(deferrals.map(({ id }) => id)).toEqual(["ask:answered", "ask:refused", "ask:replaced"]);
  });
  it("has arrows that do not cross", () => {
    const pieces = arrows.flatMap(({ id, points }) => points.slice(1).map((to, i) => ({ id, from: points[i] ?? to, to })));
    const spans = (from: number, to: number, at: number) => Math.min(from, to) < at && at < Math.max(from, to);
    const crossing = pieces.flatMap((a) => pieces.filter((b) => a.id !== b.id && a.from.y === a.to.y && b.from.x === b.to.x && spans(a.from.x, a.to.x, b.to.x) && spans(b.from.y, b.to.y, a.to.y)).map((b) => `${a.id} ${b.id}`));
    expect(crossing).toEqual([]);
  });
  it("has long labels in lines", () => {
    expect(labelLines("show_text, show_image, clear, ask")).toEqual(["show_text, show_image,", "clear, ask"]);
    expect(labelLines("a_name_that_is_longer_than_a_line")).toEqual(["a_name_that_is_longer_than_a_line"]);
  });
});
