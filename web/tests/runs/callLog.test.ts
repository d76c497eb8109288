import { describe, expect, it } from "vitest";
import type { Call, Derivation, Input, TraceStep } from "../../generated/messages";
import { folded, loggedStep, matchingEntries, servicesOf } from "../../shared/runs/callLog";

const node = (rule: string, more: Partial<Derivation> = {}): Derivation => ({ rule, equation: "", at: "Root", premises: [], ...more });
const call = (service: string, operation: string, ...args: Call["args"]): Call => ({ service, operation, args, kwargs: {} });
const calls = (service: string, operation: string) => node("SrvCall", { service, operation });
const step = (input: Input, more: Partial<TraceStep> = {}): TraceStep => ({ step: 7, input, micro: [], calls: [], ...more });
const event = (name: string): Input => ({ kind: "event", service: "robot", event: name, data: 1 });

describe("the entries of a macro step", () => {
  it("are what arrived, at its beginning, and what was called, after the micro step that called it", () => {
    const { entries } = loggedStep(step({ kind: "start" }, {
      micro: [node("Micro"), node("Micro", { premises: [node("SAct1", { premises: [calls("robot", "move"), calls("timer", "start")] })] }), node("Micro", { premises: [calls("robot", "move")] }), node("Micro", { premises: [calls("robot", "move")] })],
      calls: [call("robot", "move", 1), call("timer", "start", 2), call("robot", "move", 3), call("robot", "move", 4)],
    }));
    expect(entries.map(({ micro, kind, text }) => `7.${micro} ${kind} ${text}`)).toEqual(["7.0 run start", "7.2 call robot.move(1)", "7.2 call timer.start(2)", "7.3 call robot.move(3)", "7.4 call robot.move(4)"]);
  });
  it("have a safe call, which no micro step made, at the end, and count from the first micro step that is there", () => {
    const part = loggedStep(step({ kind: "abort" }, { first: 4, micro: [node("Micro", { premises: [calls("a", "f")] }), node("Micro")], calls: [call("a", "f"), call("robot", "stop")] }));
    expect(part.entries.map(({ micro, text }) => [micro, text])).toEqual([[0, "abort"], [5, "a.f()"], [6, "robot.stop()"]]);
  });
  it("tell a forced value, a response and its error", () => {
    expect(loggedStep(step({ kind: "force", force: { path: "Root/A", scope: "var", name: "x", value: 3 } })).entries[0]).toMatchObject({ kind: "force", text: "force Root/A var.x = 3" });
    expect(loggedStep(step({ kind: "response", call: 1, service: "db", operation: "get", error: { code: "not_found" } })).entries[0]).toMatchObject({ kind: "response", service: "db", text: expect.stringContaining("✕") as string });
  });
});

describe("the list of them", () => {
  const entries = [event("robot_state"), event("robot_state"), event("contact"), event("robot_state")].flatMap((input, i) => loggedStep(step(input, { step: i + 1 })).entries);
  it("has the same events that follow each other as one, the last", () => {
    expect(folded(entries).map(({ step, event: name, count }) => [step, name, count])).toEqual([[2, "robot_state", 2], [3, "contact", 1], [4, "robot_state", 1]]);
    expect(folded([...entries.slice(0, 1), ...loggedStep(step({ kind: "start" }, { calls: [call("timer", "start")] })).entries, ...entries.slice(1, 2)])).toHaveLength(4);
  });
  it("is filtered by kind, service and text", () => {
    const all = [...entries, ...loggedStep(step({ kind: "start" }, { calls: [call("timer", "start", 5)] })).entries];
    expect(matchingEntries(all, { kind: "call", text: "" }).map(({ text }) => text)).toEqual(["timer.start(5)"]);
    expect(matchingEntries(all, { service: "robot", text: " CONTACT " }).map(({ step: at }) => at)).toEqual([3]);
    expect(matchingEntries(all, { text: "" })).toHaveLength(all.length);
    expect(servicesOf(all)).toEqual(["robot", "timer"]);
  });
});
