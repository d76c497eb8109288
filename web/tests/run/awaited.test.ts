import { describe, expect, it } from "vitest";
import type { Input, Past } from "../../generated/messages";
import { awaitedTexts } from "../../shared/run/awaited";
import type { OpenCall } from "../../shared/run/openCalls";

const response = (service: string, operation: string): Input => ({ kind: "response", call: 1, service, operation, result: true });
const held = (...inputs: readonly Input[]): Past["waiting"] => ({ count: inputs.length, inputs: inputs.map((input) => ({ input, time: 0 })), digest: "" });
const move: OpenCall = { service: "robot", operation: "move", call: 4, coreCall: 1, time: 10 };
const reads = (...requires: string[]) => ({ requires });

describe("an atom that is unknown", () => {
  it("waits for a response that a step delivers, the first one or a later one", () => {
    const waiting = held(response("timer", "start"), response("robot", "move"));
    expect(awaitedTexts(reads("svc.timer.start.result"), waiting, [], 0)).toEqual(["timer.start: its response is queued; a step delivers it"]);
    expect(awaitedTexts(reads("svc.robot.move.result.pose", "svc.robot.move.error"), waiting, [move], 12)).toEqual(["robot.move: its response is queued; 2 steps deliver it"]);
  });
  it("waits for the answer of a call, since when it was called", () => {
    expect(awaitedTexts(reads("svc.robot.move.result"), undefined, [move], 13.2)).toEqual(["robot.move called 3.2 s ago"]);
    expect(awaitedTexts(reads("svc.robot.stop.result"), held(response("timer", "start")), [move], 13.2)).toEqual([]);
  });
  it("waits for an event", () => {
    expect(awaitedTexts(reads("svc.robot.collision"), held({ kind: "event", service: "robot", event: "collision", data: null }), [], 0)).toEqual(["robot.collision: its event is queued; a step delivers it"]);
  });
  it("tells nothing of what no service says", () => {
    expect(awaitedTexts({}, held(response("timer", "start")), [move], 0)).toEqual([]);
  });
});
