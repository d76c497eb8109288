import { describe, expect, it } from "vitest";
import type { Core, HostedService } from "../../generated/messages";
import { calledText, openCallsOf } from "../../shared/run/openCalls";

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
});
