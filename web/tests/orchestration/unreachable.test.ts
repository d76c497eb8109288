import { describe, expect, it } from "vitest";
import type { Node, RcmDocument } from "../../shared/model/model";
import { unreachableOperations, type CodePlace } from "../../shared/orchestration/unreachable";
import { action, barrier, composite, kArm, kLamp, port, service, state, task, transition } from "./models";

const lamp = (document: RcmDocument, path: string, place: CodePlace = { code: "entry", before: "" }): readonly string[] =>
  [...unreachableOperations(document, [kLamp], path, place).keys()].map((id) => id.replace("svc.lamp.", ""));

const kNothingYet = ["dim", "douse"];
const light = (...ports: readonly string[]) => state("Light", { entry: "svc.lamp.light()", ports: ports.map(port) });
const end = state("End");

describe("a sequence", () => {
  const document = task(composite("Root", [light("success: svc.lamp.light.result -> Dim", "error: svc.lamp.light.error -> End"), state("Dim", { ports: [port("go: True -> End")] }), end]));

  it("begins with the services in their first state", () => expect(lamp(document, "Root/Light")).toEqual(kNothingYet));
  it("says in which state the service is, and in which the operation is accepted", () =>
    expect(unreachableOperations(document, [kLamp], "Root/Light", { code: "entry", before: "" }).get("svc.lamp.dim")).toBe("lamp can only be in `off` here; dim is accepted in `on`"));
  it("goes on after a result where the call has led", () => expect(lamp(document, "Root/Dim")).toEqual(["light"]));
  it("goes on after an error in both, as the call may have been refused", () => expect(lamp(document, "Root/End")).toEqual([]));
  it("counts what is called after the result, before the state is left", () => {
    const busy = { ...light("success: svc.lamp.light.result -> End"), actions: [action("True", "svc.lamp.douse()")] };
    expect(lamp(task(composite("Root", [busy, end])), "Root/End")).toEqual([]);
    expect(lamp(task(composite("Root", [state("Twice", { entry: "svc.lamp.light()\nsvc.lamp.douse()", ports: [port("ok: svc.lamp.light.result -> End")] }), end])), "Root/End")).toEqual([]);
  });
  it("counts the calls in front of the place", () => {
    expect(lamp(document, "Root/Light", { code: "entry", before: "svc.lamp.light()\n" })).toEqual([]);
    expect(lamp(document, "Root/Light", { code: "entry" })).toEqual([]);
  });
  it("does not trust a condition that holds without the result", () => {
    const unsure = (when: string) => lamp(task(composite("Root", [light(`success: ${when} -> Dim`), state("Dim")])), "Root/Dim");
    expect(unsure("available(svc.lamp.light.result) and True")).toEqual(["light"]);
    expect(unsure("svc.lamp.light.result or True")).toEqual([]);
    expect(unsure("not svc.lamp.light.result")).toEqual([]);
    expect(unsure("svc.lamp.dim.result")).toEqual([]);
  });
});

it("marks nothing in a state to which nothing leads", () => expect(lamp(task(composite("Root", [light(), end])), "Root/End")).toEqual([]));

it("follows a loop", () => {
  const document = task(composite("Root", [state("Wait", { ports: [port("go: True -> Light")] }), light("again: True -> Wait")]));
  expect(lamp(document, "Root/Wait")).toEqual([]);
});

describe("a service that moves by itself", () => {
  const move = (when: string) => task(composite("Root", [state("Move", { entry: "svc.arm.move()", ports: [port(`there: ${when} -> Next`)], exit: "pass" }), state("Next")]));
  const arm = (document: RcmDocument, path: string, place: CodePlace = { code: "entry", before: "" }) => [...unreachableOperations(document, [kArm], path, place).keys()];
  it("may be in both states", () => expect(arm(move("True"), "Root/Next")).toEqual([]));
  it("has come to the end of a motion that it has answered", () => expect(arm(move("svc.arm.move.result"), "Root/Next")).toEqual(["svc.arm.halt"]));
  it("may be in both in an action and in the exit", () => {
    expect(arm(move("svc.arm.move.result"), "Root/Move", { code: "action" })).toEqual([]);
    expect(arm(move("svc.arm.move.result"), "Root/Move", { code: "exit" })).toEqual([]);
  });
});

describe("nested states", () => {
  const inner = composite("Inner", [light("success: svc.lamp.light.result"), end], { ports: [port("done: chi.Light.port.success -> After"), port("stopped: svc.lamp.light.error -> Stopped")], exit: "pass" });
  const document = task(composite("Root", [inner, state("After"), state("Stopped")]));
  it("are left in the states in which the port of their child was", () => expect(lamp(document, "Root/After")).toEqual(["light"]));
  it("are left in any of the states inside", () => expect(lamp(document, "Root/Stopped")).toEqual([]));
  it("see what the actions around them call", () => {
    const acting = task(composite("Root", [end], { actions: [action("True", "svc.lamp.light()")] }));
    expect(lamp(acting, "Root/End")).toEqual([]);
    expect(lamp(acting, "Root")).toEqual(kNothingYet);
  });
  it("are left through their exits from the inside to the outside", () => {
    const leaving = task(composite("Root", [composite("Inner", [state("Leaf", { exit: "svc.lamp.light()" })], { ports: [port("out: True -> End")] }), end]));
    expect(lamp(leaving, "Root/Inner", { code: "exit", before: "" })).toEqual([]);
    expect(lamp(leaving, "Root/End")).toEqual([]);
    expect(lamp(leaving, "Root/Inner/Leaf", { code: "exit", before: "" })).toEqual(kNothingYet);
  });
});

describe("concurrent states", () => {
  const document = task(
    composite("Root", [barrier("Fork", "A", "B"), state("A", { ports: [port("done: True -> Join")] }), state("B", { entry: "svc.lamp.light()", ports: [port("done: svc.lamp.light.result -> Join")] }), barrier("Join", "After"), state("After")]),
  );
  it("see each other's calls", () => expect(lamp(document, "Root/A")).toEqual([]));
  it("join in the states in which one of them was left", () => expect(lamp(document, "Root/After")).toEqual([]));
  it("are two only where a barrier leads to several", () => {
    const one = task(composite("Root", [barrier("First", "A"), state("A", { ports: [port("done: True -> Light")] }), light()]));
    expect(lamp(one, "Root/A")).toEqual(kNothingYet);
  });
});

describe("links", () => {
  const skill = composite("Skill", [state("Work", { ports: [port("done: True")] })], { ports: [port("done: chi.Work.port.done")] });
  const link = (name: string, ...ports: readonly string[]) => state(name, { link: "Skill", ports: ports.map(port) });
  it("lead to a library state, which is seen wherever it is linked", () => {
    const first = task(composite("Root", [link("One", "done:  -> Light"), light("ok: True -> End"), end]), skill);
    expect(lamp(first, "Skill/Work")).toEqual(kNothingYet);
    const both = task(composite("Root", [link("One", "done:  -> Light"), light("ok: True -> Two"), link("Two")]), skill);
    expect(lamp(both, "Skill/Work")).toEqual([]);
    expect(lamp(both, "Root/Light")).toEqual(kNothingYet);
  });
  it("say nothing if they lead nowhere or in a circle", () => {
    expect(lamp(task(composite("Root", [state("Lost", { link: "None", ports: [port("done: True -> End")] }), end])), "Root/End")).toEqual([]);
    expect(lamp(task(composite("Root", [end]), composite("Skill", [link("Again")])), "Skill/Again")).toEqual([]);
    expect(lamp(task(composite("Root", [link("One")]), composite("Skill", [link("Again")])), "Root")).toEqual([]);
  });
});

describe("oracles", () => {
  const children = [state("Choice"), light("ok: True -> Choice"), state("Dark")];
  it("may begin with any child", () => {
    expect(lamp(task(composite("Root", children, { oracle: "expr" })), "Root/Dark")).toEqual(kNothingYet);
    expect(lamp(task(composite("Root", children)), "Root/Dark")).toEqual([]);
  });
  it("that ask a service may have called anything", () => expect(lamp(task(composite("Root", children, { oracle: "external" })), "Root/Dark")).toEqual([]));
  it("that remember let what is inside begin with any child", () => {
    const inside = composite("Inside", [state("A"), light(), state("B")]);
    expect(lamp(task(composite("Root", [inside], { oracle: "history" })), "Root/Inside/B")).toEqual(kNothingYet);
  });
});

describe("code", () => {
  const entered = (entry: string) => lamp(task(composite("Root", [state("A", { entry, ports: [port("go: True -> B")] }), state("B")])), "Root/B");
  it("may call a service that is computed", () => expect(entered("svc[par.name].light()")).toEqual([]));
  it("may call in another order if it repeats", () => {
    const arm = service("arm", "a", [transition("t1: a x -> b"), transition("t2: b y -> c"), transition("t3: c z -> c")]);
    const marked = (entry: string) => [...unreachableOperations(task(composite("Root", [state("A", { entry, ports: [port("go: True -> B")] }), state("B")])), [arm], "Root/B", { code: "entry" }).keys()];
    expect(marked("svc.arm.y()\nsvc.arm.x()")).toEqual(["svc.arm.z"]);
    expect(marked("for i in range(2):\n  svc.arm.y()\n  svc.arm.x()")).toEqual([]);
  });
});

it("knows that a port with a time-out calls the timer", () => {
  const timer = service("timer", "idle", [transition("t1: idle wait -> waiting"), transition("t2: waiting cancel -> idle")]);
  const marked = (timed: boolean) => [...unreachableOperations(task(composite("Root", [state("A", { ports: [timed ? { name: "late", after: "2.5" } : port("late: True")] })])), [timer], "Root/A", { code: "action" }).keys()];
  expect([marked(true), marked(false)]).toEqual([[], ["svc.timer.cancel"]]);
});

it("says nothing of a service whose RSM has no states", () => {
  const plain = { key: "lamp", rsm: { rsm: 1, name: "lamp", operations: [{ name: "light" }], events: [] } } as const;
  expect(unreachableOperations(task(state("Root")), [plain], "Root", { code: "entry" }).size).toBe(0);
});

it("counts what services call by themselves", () => {
  const switching = { key: "house", rsm: { rsm: 1, name: "house", operations: [], events: [], init: "on", states: [{ name: "on" }], calls: [{ service: "lamp", operation: "light" }] } } as const;
  expect([...unreachableOperations(task(state("Root")), [kLamp, switching], "Root", { code: "entry" }).keys()]).toEqual([]);
});

it("takes less than half a second for 2 000 states, and is kept for the same document", () => {
  const count = 500;
  const block = (i: number): readonly Node[] => [
    barrier(`Fork${i}`, `A${i}`, `B${i}`),
    state(`A${i}`, { entry: "svc.lamp.light()", ports: [port(`ok: svc.lamp.light.result -> Join${i}`)] }),
    composite(`B${i}`, [state("X", { entry: "svc.arm.move()" }), state("Y")], { ports: [port(`ok: True -> Join${i}`)] }),
    barrier(`Join${i}`, `A${(i + 1) % count}`, `B${(i + 1) % count}`),
  ];
  // The last first: what is known passes through the model against its order.
  const children = Array.from({ length: count }, (_, i) => block(count - 1 - i)).flat();
  const document = task(state("Root", { children, first: "Fork0" }));
  // Of the processor: the machine may be busy with something else.
  const seconds = (): number => {
    const before = process.cpuUsage();
    unreachableOperations(document, [kLamp, kArm], "Root/A7", { code: "entry" });
    return process.cpuUsage(before).user / 1e6;
  };
  const first = seconds();
  console.log(`first: ${first.toFixed(3)} s`);
  expect(first).toBeLessThan(0.5);
  expect(seconds()).toBeLessThan(0.1);
});
