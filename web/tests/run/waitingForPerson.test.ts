import { describe, expect, it } from "vitest";
import type { Call, Core, HostedService, TraceStep } from "../../generated/messages";
import { displayAddress } from "../../shared/run/displayCalls";
import { callThatAsked, waitingForPerson, withQuestions } from "../../shared/run/waitingForPerson";

const core: Core = { id: "7", document: "pick", revision: 3, status: "running", paused: false, stepping: false, step: 12, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };
const service = (key: string, type: string, pending: HostedService["pending"]): HostedService => ({
  key, type, pending, state: null, available: true, pending_count: pending.length, violations: [], publishes: [], subscribes: [], rsm: { rsm: 1, name: type, operations: [], events: [] },
});
const step = (...calls: readonly Call[]): TraceStep => ({ step: 4, input: { kind: "start" }, micro: [], calls });
const ask: Call = { service: "phone", operation: "ask", args: ["Is the table empty?"], kwargs: { display: "arm" }, call: 9 };
const pending = [{ call: 30, operation: "ask", time: 2, core: "7", core_call: 9 }];

describe("a run that waits for a person", () => {
  it("says what is asked, and where", () => {
    const wait = waitingForPerson(core, [service("robot", "robot", []), service("phone", "display", pending)], [{ ...ask, service: "robot" }, ask]);
    expect(wait).toEqual({ service: "phone", operation: "ask", call: 9, question: "Is the table empty?", answers: { buttons: ["OK"] }, display: "arm" });
    expect(wait && displayAddress(wait.display)).toBe("/display/?name=arm");
    expect([displayAddress("all"), displayAddress("@gripper")]).toEqual(["/display/", "/display/?place=gripper"]);
  });
  it("knows the displays as an argument by place, and the question by name", () => {
    const number: Call = { service: "phone", operation: "ask_number", args: [], kwargs: { question: "How many?" }, call: 9 };
    const wait = waitingForPerson(core, [service("phone", "display", [{ call: 30, operation: "ask_number", time: 2, core: "7", core_call: 9 }])], [number]);
    expect(wait).toMatchObject({ question: "How many?", display: "all" });
    const placed: Call = { ...ask, args: ["Ready?", ["OK"], "arm"], kwargs: {} };
    expect(waitingForPerson(core, [service("phone", "display", pending)], [placed])).toMatchObject({ display: "arm" });
  });
  it("waits also when the call that asked is not here", () => {
    expect(waitingForPerson(core, [service("phone", "display", pending)], [])).toEqual({ service: "phone", operation: "ask", call: 9, question: undefined, answers: undefined, display: "all" });
  });
  it("knows the answers by the arguments of the call", () => {
    const answers = (operation: string, args: Call["args"], kwargs: Call["kwargs"] = {}) =>
      waitingForPerson(core, [service("phone", "display", [{ call: 30, operation, time: 2, core: "7", core_call: 9 }])], [{ ...ask, operation, args, kwargs }])?.answers;
    expect(answers("ask", ["Go?", ["Continue", "Abort"]])).toEqual({ buttons: ["Continue", "Abort"] });
    expect(answers("choose", ["Which?"], { choices: ["A", "B"] })).toEqual({ buttons: ["A", "B"] });
    expect(answers("ask_number", ["How many?", 1, 9], { unit: "mm", initial: 2 })).toEqual({ number: { min: 1, max: 9, unit: "mm", initial: 2 } });
    expect([answers("choose", ["Which?"]), answers("ask_number", ["How many?", 1])]).toEqual([undefined, undefined]);
  });
  it("finds the call that asked where the page has it not, going back in parts", async () => {
    const wait = waitingForPerson(core, [service("phone", "display", pending)], []);
    if (wait === undefined) throw new Error("it waits");
    const parts: (readonly [number, number])[] = [];
    const load = (from: number, to: number) => {
      parts.push([from, to]);
      return Promise.resolve(from <= 4 && 4 <= to ? [step({ ...ask, service: "robot" }), step(ask)] : []);
    };
    expect(await callThatAsked(wait, 120, load)).toEqual(ask);
    expect(parts).toEqual([[71, 120], [21, 70], [1, 20]]);
    parts.length = 0;
    expect(await callThatAsked({ ...wait, call: 10 }, 9000, load)).toBeUndefined();
    expect(parts.length).toBe(20);
    expect(parts.at(-1)).toEqual([8001, 8050]);
  });
  it("keeps the questions among its calls, the last ones", () => {
    const shown: Call = { ...ask, operation: "show_text", call: 10 };
    expect(withQuestions([ask], [shown, { ...ask, call: 11 }]).map(({ call }) => call)).toEqual([9, 11]);
    const known = [ask];
    expect(withQuestions(known, [shown])).toBe(known);
    const many = Array.from({ length: 80 }, (_, call): Call => ({ ...ask, call }));
    expect([withQuestions(known, many).length, withQuestions(known, many).at(-1)?.call]).toEqual([50, 79]);
  });
  it("is no run whose text is shown, of another core, or that is over", () => {
    const of = (entry: Partial<HostedService["pending"][number]>) => [service("phone", "display", [{ call: 30, operation: "ask", time: 2, core: "7", core_call: 9, ...entry }])];
    expect(waitingForPerson(core, of({ operation: "show_text" }), [ask])).toBeUndefined();
    expect(waitingForPerson(core, of({ core: "8" }), [ask])).toBeUndefined();
    expect(waitingForPerson({ ...core, status: "aborted" }, of({}), [ask])).toBeUndefined();
    expect(waitingForPerson(core, [service("robot", "robot", pending)], [ask])).toBeUndefined();
  });
});
