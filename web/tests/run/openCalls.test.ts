import { describe, expect, it } from "vitest";
import type { Core, HostedService } from "../../generated/messages";
import { calledText, openCallsOf } from "../../shared/run/openCalls";
import type { PersonWait } from "../../shared/run/waitingForPerson";

const core = { id: "2" } as Core;
const service = (key: string, pending: readonly object[]) => ({ key, pending }) as unknown as HostedService;

describe("the open calls of a run", () => {
  const services = [service("robot", [{ call: 9, operation: "move", time: 12.5, core: "2" }, { call: 3, operation: "move", time: 1, core: "1" }]), service("timer", [{ call: 7, operation: "wait", time: 12, core: "2" }, { call: 8, operation: "wait", time: 12.2 }])];
  it("are its own, oldest first", () => expect(openCallsOf(core, services).map(({ service, call }) => `${service} ${call}`)).toEqual(["timer 7", "robot 9"]));
  it("say since when, if the time of the cell is known", () => {
    const [call] = openCallsOf(core, services);
    if (call === undefined) throw new Error("no call");
    expect(calledText(call, 15.24)).toBe("called 3.2 s ago");
    expect(calledText(call, undefined)).toBe("called, not answered yet");
    expect(calledText(call, 11)).toBe("called, not answered yet");
  });
  it("say what a person is asked by them", () => {
    const wait: PersonWait = { service: "phone", operation: "ask", call: 4, question: "Ready?", answers: undefined, display: "all" };
    const calls = openCallsOf(core, [service("phone", [{ call: 9, operation: "ask", time: 1, core: "2", core_call: 4 }, { call: 10, operation: "ask", time: 2, core: "2", core_call: 5 }])]);
    expect(calls.map((call) => calledText(call, 3, wait))).toEqual(["“Ready?”, called 2.0 s ago", "called 1.0 s ago"]);
    expect(calls.map((call) => calledText(call, 3, { ...wait, service: "screen" }))).toEqual(["called 2.0 s ago", "called 1.0 s ago"]);
  });
});
