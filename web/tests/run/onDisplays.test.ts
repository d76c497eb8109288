import { describe, expect, it } from "vitest";
import type { Call, HostedService, Input } from "../../generated/messages";
import { displayOf, displaysText, ownDisplayFor, placeOf } from "../../shared/run/displayCalls";
import { kNothingTold, tellDisplays, textOn, unseenOf, type OnDisplays } from "../../shared/run/onDisplays";

const service = (key: string, type: string, ...moving: readonly string[]): Pick<HostedService, "key" | "type" | "rsm"> => ({ key, type, rsm: { rsm: 1, name: type, operations: moving.map((name) => ({ name, moves: true })), events: [] } });
const services = [service("phone", "display"), service("robot", "robot", "move"), service("timer", "timer")];
const call = (operation: string, number: number, ...args: Call["args"]): Call => ({ service: "phone", operation, args, kwargs: {}, call: number });
const answer = ({ service: of, operation, call: number = 0 }: Call, error?: string): Input => ({ kind: "response", service: of, operation, call: number, ...(error === undefined ? { result: null } : { error: { code: error, message: "no" } }) });

type Step = Parameters<typeof tellDisplays>[1];
const after = (...steps: readonly Step[]): OnDisplays => steps.reduce((told, step) => tellDisplays(told, step, services), kNothingTold);
const takes = (each: Call): readonly Step[] => [{ calls: [each] }, { input: answer(each), calls: [] }];
const refuses = (each: Call, code = "no_display"): readonly Step[] => [{ calls: [each] }, { input: answer(each, code), calls: [] }];

const lead = call("show_text", 1, "Lead the arm");
const ask = call("ask", 2, "What is to be done?", ["Continue", "Abort"]);

describe("what a run has told the displays", () => {
  it("is read there, whether or not the run hears of it, until something else is, or they are cleared", () => {
    expect([after({ calls: [lead] }).shown, after(...takes(lead)).shown, after(...refuses(lead, "too_large")).shown]).toEqual([lead, lead, undefined]);
    const count = call("show_text", 3, "1 of 10 places", [], "arm");
    expect(after(...takes(lead), ...takes(count)).shown).toBe(count);
    expect(after(...takes(lead), ...takes(ask)).shown).toBe(lead);
    expect(after(...takes(lead), { calls: [call("clear", 4)] }).shown).toBeUndefined();
    expect([textOn(lead), displayOf(count), ownDisplayFor(displayOf(lead))]).toEqual(["Lead the arm", "arm", "expert-page"]);
  });
  it("is seen by nobody without a display, until one takes something or the run moves something", () => {
    const unseen = after(...takes(lead), ...refuses(ask));
    expect(unseen).toEqual({ open: [], shown: lead, unseen: ask });
    expect(after(...refuses(ask, "display_lost")).unseen).toBe(ask);
    const again = { ...ask, call: 7 };
    expect(after(...refuses(ask), { calls: [again, { ...ask, service: "timer", operation: "wait" }] }).unseen).toBe(ask);
    expect(after(...refuses(ask), ...takes(again)).unseen).toBeUndefined();
    expect(after(...refuses(ask), { calls: [{ ...ask, service: "robot", operation: "move" }] }).unseen).toBeUndefined();
  });
  it("is seen by nobody either if a display refuses what the run hears no response of", () => {
    const states = (last: string, pending_count = 0) => [{ key: "robot", last: "refused", pending_count: 0 }, { key: "phone", last, pending_count }];
    const asked = after({ calls: [lead] }, { calls: [ask] });
    expect(["refused", "lost", "answered", "ask"].map((last) => unseenOf(asked, states(last)))).toEqual([{ call: ask, isHeard: false }, { call: ask, isHeard: false }, undefined, undefined]);
    expect([unseenOf(asked, states("refused", 1)), unseenOf(after(...refuses(ask)), states("refused")), unseenOf(after({ calls: [lead] }), states("refused"))]).toEqual([undefined, { call: ask, isHeard: true }, undefined]);
    expect(unseenOf(after({ calls: [ask] }, { calls: [{ ...ask, service: "robot", operation: "move" }] }), states("refused"))).toBeUndefined();
  });
  it("is not what is wrong with a call, nor of another service, nor that nothing could be cleared", () => {
    expect(after(...refuses(ask, "too_large"))).toEqual(kNothingTold);
    expect(after(...refuses(call("clear", 5)))).toEqual(kNothingTold);
    expect(after(...refuses({ ...ask, service: "robot" }))).toEqual(kNothingTold);
  });
  it("keeps one open call of each operation", () => {
    expect(after(...Array.from({ length: 50 }, (_, i) => ({ calls: [call("ask", i + 1, "?")] }))).open).toEqual([call("ask", 50, "?")]);
  });
  it("has the words of each operation", () => {
    const named: Call = { ...ask, args: [], kwargs: { question: "Ready?", display: "arm" } };
    const picture = { ...call("show_image", 1, "part.png") };
    expect([textOn(named), displayOf(named), textOn(picture), textOn({ ...picture, args: ["part.png", "The part"] }), textOn({ ...lead, args: [""] })]).toEqual(["Ready?", "arm", "a picture", "The part", undefined]);
  });
  it("has the words of progress, and of the displays at a place", () => {
    const progress = call("show_progress", 1, "Calibrating", 0.4, "@gripper");
    expect(after(...takes(progress)).shown).toBe(progress);
    expect([textOn(progress), displayOf(progress), ownDisplayFor("@gripper"), placeOf("@gripper"), placeOf("gripper")]).toEqual(["Calibrating", "@gripper", "expert-page", "gripper", undefined]);
    expect(["all", "@gripper", "arm"].map(displaysText)).toEqual(["every display", "the displays at gripper", "the display arm"]);
  });
});
