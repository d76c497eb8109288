// The parts of services of one's own (race-client/service) without a server.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { JsonObject, JsonValue } from "../../api/typescript/src/json";
import { bindArguments } from "../../api/typescript/src/service/arguments";
import { Declaration, DeclarationError } from "../../api/typescript/src/service/declaration";
import { Hosted, kMaxCalls } from "../../api/typescript/src/service/hosted";
import { Machine } from "../../api/typescript/src/service/machine";
import { kMaxOut, Outbox } from "../../api/typescript/src/service/outbox";
import { readRsm, type Transition } from "../../api/typescript/src/service/rsm";
import { operation, Service } from "../../api/typescript/src/service/index";
import { checkedError, checkedValue } from "../../api/typescript/src/service/values";
import { project } from "./servers";

const kHere = fileURLToPath(import.meta.url);
const lines = readFileSync(kHere, "utf8").split("\n");
const lineOf = (text: string): number => lines.findIndex((line) => line.includes(text)) + 1;

class Nameless extends Service {
  key = "";
}
class Wrong extends Service {
  key = "wrong";
  move = operation({ parameters: { width: { type: "number", min: NaN } } }, () => 1);
}
class Idle extends Service {
  key = "idle";
  stop = operation({ stops: "Moving" }, () => 1);
}
class Absent extends Service {
  key = "absent";
  override rsm = { rsm: 1, name: "absent", operations: [{ name: "go" }], events: [] };
}
class Fileless extends Service {
  key = "fileless";
  override rsm = "nowhere.rsm.json";
}
class Patient extends Service {
  key = "patience";
  override rsm = join(project, "tests/integration/patience.rsm.json");
  begin = operation(() => "begun");
  wait = operation(() => 1);
}

describe("declarations", () => {
  const refusal = (service: Service): string => {
    try {
      new Declaration(service);
    } catch (error) {
      if (error instanceof DeclarationError) return error.message;
      throw error;
    }
    return "";
  };

  it("what is wrong is named with its line", () => {
    const here = (text: string): string => `serviceRules.test.ts:${lineOf(text)}: error: `;
    expect(refusal(new Nameless())).toContain("serviceRules.test.ts:");
    expect(refusal(new Wrong())).toContain("JSON has no NaN");
    expect(refusal(new Idle())).toContain(here("stop = operation({ stops"));
    expect(refusal(new Absent())).toContain("the RSM has the operation `go`, and Absent has none of this name");
    expect(refusal(new Fileless())).toContain("nowhere.rsm.json:1: error: ");
  });

  it("a violation is about the line of the name in a file", () => {
    const declaration = new Declaration(new Patient());
    const file = join(project, "tests/integration/patience.rsm.json");
    const lineWith = (name: string): number => readFileSync(file, "utf8").split("\n").findIndex((line) => line.includes(`"${name}"`)) + 1;
    expect(declaration.where("wait")).toBe(`${file}:${lineWith("wait")}`);
    expect(declaration.whereViolated({ operation: "", message: "`over` waits for no call" })).toBe(`${file}:${lineWith("over")}`);
  });
});

describe("rules of core/SEMANTICS.md, section 5", () => {
  const machine = (...transitions: readonly Transition[]): Machine => new Machine({ init: "A", transitions });

  it("the first transition of the present state takes a call", () => {
    const go = { id: "go", src: "A", dst: "B", operation: "go" };
    const anywhere = { id: "anywhere", dst: "A", operation: "go" };
    const of = machine(go, anywhere);
    expect(of.accepting("go")).toBe(go);
    of.take(go, 1);
    expect(of.accepting("go")).toBe(anywhere);
    expect(of.accepting("stay")).toBe(undefined);
  });

  it("a later call supersedes an earlier one", () => {
    const go = { id: "go", src: "A", dst: "A", operation: "go", defer: ["done"] };
    const done = { id: "done", src: "A", dst: "A" };
    const of = machine(go, done);
    expect(of.take(go, 1)).toEqual({ resolved: [], superseded: 0 });
    expect(of.take(go, 2)).toEqual({ resolved: [], superseded: 1 });
    expect(of.take(done)).toEqual({ resolved: [{ call: 2, code: undefined }], superseded: 0 });
    expect(of.take(done)).toEqual({ resolved: [], superseded: 0 });
  });

  it("concurrent calls are answered one by one or all", () => {
    const wait = { id: "wait", src: "A", dst: "A", operation: "wait", defer: ["over", "end"], isConcurrent: true };
    const [over, end] = [{ id: "over", src: "A", dst: "A" }, { id: "end", dst: "A", error: "ended" }];
    const of = machine(wait, over, end);
    for (const call of [1, 2, 3, 4]) of.take(wait, call);
    expect(of.take(over, 3).resolved).toEqual([{ call: 3, code: undefined }]);
    expect(of.take(over).resolved).toEqual([{ call: 1, code: undefined }]);
    expect(of.take(end).resolved).toEqual([{ call: 2, code: "ended" }, { call: 4, code: "ended" }]);
  });

  it("an operation ends the earliest of concurrent calls", () => {
    const wait = { id: "wait", src: "A", dst: "A", operation: "wait", defer: ["stop"], isConcurrent: true };
    const stop = { id: "stop", src: "A", dst: "A", operation: "stop", error: "stopped" };
    const of = machine(wait, stop);
    for (const call of [1, 2]) of.take(wait, call);
    expect(of.take(stop, 3).resolved).toEqual([{ call: 1, code: "stopped" }]);
  });

  it("an error leads by the transition of its code", () => {
    const go = { id: "go", src: "A", dst: "B", operation: "go", defer: ["jam", "done", "stop"] };
    const [jam, done] = [{ id: "jam", src: "B", dst: "A", error: "jammed" }, { id: "done", src: "B", dst: "A" }];
    const of = machine(go, jam, done, { id: "stop", src: "B", dst: "A", operation: "stop" });
    of.take(go, 1);
    expect([of.ending(go, "jammed"), of.ending(go, "other"), of.ending(go, undefined)]).toEqual([jam, done, done]);
  });

  it("arguments are held against the parameters", () => {
    const { operations } = readRsm({
      operations: [{ name: "move", parameters: [{ name: "width", type: "number", min: 0, max: 1, unit: "m" }, { name: "name", type: "string", value: "x" }, { name: "on", type: "bool", value: false }] }],
    });
    const bind = (args: readonly JsonValue[], kwargs: JsonObject = {}) => bindArguments(operations[0]?.parameters ?? [], args, kwargs);
    const wrong: readonly (readonly [string, readonly JsonValue[], JsonObject?])[] = [
      ["invalid", []], ["invalid", [1, "", false, 4]], ["invalid", [0.5], { speed: 1 }], ["invalid", [0.5], { width: 1 }], ["out_of_range", [-0.1]], ["out_of_range", [1.1]],
      ["invalid", [true]], ["invalid", ["1"]], ["invalid", [1], { name: 5 }], ["invalid", [1], { on: 1 }], ["invalid", [1], { constructor: 1 }],
    ];
    for (const [code, args, kwargs] of wrong) expect(bind(args, kwargs).error?.code, JSON.stringify([args, kwargs])).toBe(code);
    expect(bind([0]).values).toEqual({ width: 0, name: "x", on: false });
    expect(bind([1, "y", true]).values).toEqual({ width: 1, name: "y", on: true });
    expect(bind([], { width: 0.5, on: true }).values).toEqual({ width: 0.5, name: "x", on: true });
    expect(bind([2]).error).toEqual({ code: "out_of_range", message: "`width` must be at least 0 and at most 1 m", argument: "width" });
  });
});

describe("what a service says", () => {
  it("a value that the server would not read is none", () => {
    const deep = (levels: number): unknown => Array.from({ length: levels }).reduce((inner) => [inner], 1);
    for (const value of [NaN, Infinity, 2 ** 63, -(2 ** 64), 1n, "\ud800", { "\udc00": 1 }, new Date(), new Map(), [undefined], () => 1, deep(65)]) {
      expect(() => checkedValue(value)).toThrow(/JSON has no|64 bits|character|levels/);
    }
    for (const value of [null, 0, -(2 ** 63), 1e21, "😀", { a: [{ b: undefined }] }, deep(64)]) expect(checkedValue(value)).toBe(value);
    expect(checkedValue(undefined)).toBe(null);
    expect(checkedError({ code: 5 })["message"]).toContain("its `code` is no text");
    expect(checkedError({ code: "jammed", force: Infinity })).toMatchObject({ code: "failed" });
  });

  it("what the server does not take is bounded", () => {
    const sent: string[] = [];
    let full = 0;
    const outbox = new Outbox({ bufferedAmount: 1e6, send: (text) => sent.push(text) }, () => full++);
    for (let i = 0; i < kMaxOut; i++) outbox.say("x");
    expect([sent.length, full]).toEqual([0, 0]);
    outbox.say("one more");
    expect([sent.length, full]).toEqual([0, 1]);
    outbox.close();
  });
});

describe("silence", () => {
  class Cart extends Service {
    key = "cart";
    ended: string[] = [];
    lift = operation({ moves: true, busy: "Lifting" }, async (_, { pause }) => await pause(600).finally(() => this.ended.push("lift")));
    drive = operation({ moves: true }, async (_, { pause }) => await pause(600).finally(() => this.ended.push("drive")));
    brake = operation({ safe: true }, async (_, { pause }) => await pause(0.1));
  }
  class Simple extends Cart {
    override rsm = { rsm: 1, name: "simple", events: [], operations: [{ name: "drive", moves: true, error: "any" }, { name: "brake", safe: true, error: "any" }] };
  }

  /** What answers each of these calls when the service hears nothing then. */
  async function afterSilence(service: Service, ...names: readonly string[]): Promise<readonly JsonValue[]> {
    const said: JsonObject[] = [];
    const hosted = new Hosted(service, () => undefined);
    hosted.connected((message) => said.push(message));
    for (const [index, operation] of names.entries()) hosted.received({ type: "call", key: service.key, call: index + 1, operation, args: [], kwargs: {} });
    await new Promise((begun) => setTimeout(begun));
    await hosted.silent();
    const answer = (number: number) => said.find(({ type, call }) => (type === "result" || type === "error") && call === number);
    await vi.waitFor(() => expect(names.every((_, index) => answer(index + 1) !== undefined)).toBe(true));
    return [hosted.state, ...names.map((_, index) => (answer(index + 1)?.["error"] as JsonObject | undefined)?.["code"] ?? "result")];
  }

  it("silence ends what is under way but for what is safe", async () => {
    const [cart, simple] = [new Cart(), new Simple()];
    expect(await afterSilence(cart, "lift", "drive", "brake")).toEqual(["Ready", "stopped", "stopped", "result"]);
    expect(await afterSilence(simple, "drive", "brake")).toEqual(["", "stopped", "result"]);
    expect([cart.ended.sort(), simple.ended]).toEqual([["drive", "lift"], ["drive"]]);
  });
});

describe("calls at work", () => {
  class Busy extends Service {
    key = "busy";
    ends: (() => void)[] = [];
    wait = operation(() => new Promise<void>((resolve) => this.ends.push(resolve)));
    answer = operation({ parameters: { value: { type: "int" } } }, ({ value }) => value);
  }

  /** A service, and what it says. */
  function host(): { readonly service: Busy; readonly said: JsonObject[]; readonly call: (number: number, name: string, ...args: readonly JsonValue[]) => void } {
    const [service, said] = [new Busy(), [] as JsonObject[]];
    const hosted = new Hosted(service, () => undefined);
    hosted.connected((message) => said.push(message));
    return { service, said, call: (number, operation, ...args) => hosted.received({ type: "call", key: "busy", call: number, operation, args, kwargs: {} }) };
  }

  it("a hundred are at work and no more", async () => {
    const { service, said, call } = host();
    for (let number = 1; number <= kMaxCalls; number++) call(number, "wait");
    call(101, "answer", 5);
    expect(said.at(-1)).toMatchObject({ type: "error", call: 101, error: { code: "too_many" } });
    await vi.waitFor(() => expect(service.ends.length).toBe(kMaxCalls));
    service.ends.shift()?.();
    await vi.waitFor(() => expect(said.at(-1)).toEqual({ key: "busy", type: "result", call: 1, value: null }));
    call(102, "answer", 5);
    await vi.waitFor(() => expect(said.at(-1)).toEqual({ key: "busy", type: "result", call: 102, value: 5 }));
    call(103, "nothing");
    expect(said.at(-1)).toEqual({ key: "busy", type: "reject", call: 103 });
  });
});
