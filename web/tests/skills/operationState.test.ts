// States that call an operation of a service.
import { expect, test } from "vitest";
import type { RsmOperation, Type } from "../../generated/messages";
import { mistakesIn } from "../../shared/code/mistakes";
import { scopeOf } from "../../shared/code/scope";
import { placeIn } from "../../shared/edit/commands/place";
import { apply, type Operation } from "../../shared/edit/apply";
import { plain, writeExact } from "../../shared/edit/exact";
import { kMaxMessageBytes } from "../../shared/edit/session";
import { elementOf, listOf } from "../../shared/edit/tree";
import { addOperation } from "../../shared/skills/addOperation";
import { offeredOperations, operationState } from "../../shared/skills/operationState";
import { after, newIds, reasonOf } from "../edit/commands/fixture";
import { documentText, textOf, treeOf } from "../edit/documents";
import { emptyApp, emptyJson } from "./fixture";
import { firstOf, gripper, serviceOf } from "./services";

const stateOf = (operation: RsmOperation) => operationState(serviceOf("s", [operation]), operation);
const names = (operations: readonly RsmOperation[], key = "s") => offeredOperations(serviceOf(key, operations)).map(({ name }) => name);
const parameter = (about: object) => (stateOf({ name: "do", parameters: [{ name: "p", ...about }] })["parameters"] as readonly unknown[])[0];

test("a state calls the operation with its parameters, and leaves when it is done or has failed; left before, it stops the motion", () => {
  expect(operationState(gripper, firstOf(gripper))).toEqual({
    state: "MyGripperMove",
    doc: "Calls `move` of the service my_gripper.",
    parameters: [{ name: "width", type: "number", unit: "m", meta: { min: 0, max: 0.11, step: 0.002 } }],
    results: [{ name: "why", type: "string", doc: "What went wrong, in the words of the service", meta: { title: "What went wrong" } }],
    entry: "svc.my_gripper.move(par.width)",
    exit: "if not available(svc.my_gripper.move.result) and not available(svc.my_gripper.move.error):\n    svc.my_gripper.stop()",
    actions: [{ when: "svc.my_gripper.move.error", do: "e = svc.my_gripper.move.error\nres.why = e.get('message', 'my_gripper: ' + e.code)" }],
    ports: [
      { name: "done", when: "svc.my_gripper.move.result", meta: { nominal: true, title: "It is done" } },
      { name: "error", when: "svc.my_gripper.move.error and available(res.why)", meta: { advice: "See what went wrong, then try again.", title: "The service has not done it" } },
    ],
  });
});

test("the fields of a record are results, if all of them are there and can be named; any other answer is one", () => {
  const resultsOf = (result?: Type) => {
    const { results, actions, ports } = stateOf({ name: "get", ...(result !== undefined && { result }) }) as { readonly results: readonly { readonly name: string; readonly type: Type }[]; readonly actions: readonly { readonly do: string }[]; readonly ports: readonly { readonly when: string }[] };
    return [results.map(({ name }) => name), actions.length === 2 ? actions[0]?.do : undefined, ports[0]?.when];
  };
  expect(resultsOf({ record: { width: "number", held: "bool" } })).toEqual([["width", "held", "why"], 'r = svc.s.get.result\nres.width = r["width"]\nres.held = r["held"]', "svc.s.get.result and available(res.width)"]);
  const whole = [["result", "why"], "r = svc.s.get.result\nres.result = r", "svc.s.get.result and available(res.result)"];
  const types: readonly Type[] = ["number", { list: "pose" }, "any", { record: { width: { optional: "number" } } }, { record: { in: "number" } }, { record: { __init: "number" } }, { record: { why: "string" } }];
  for (const type of types) expect(resultsOf(type)).toEqual(whole);
  for (const type of [undefined, "null", { record: {} }] as const) expect(resultsOf(type)).toEqual([["why"], undefined, "svc.s.get.result"]);
});

test("a parameter has its default as the document takes it, and is required without one", () => {
  expect(writeExact(parameter({ type: "number", value: 1 }))).toBe('{"name":"p","value":1.0,"type":"number"}');
  expect(writeExact(parameter({ type: "int", value: 1 }))).toBe('{"name":"p","value":1,"type":"int"}');
  expect(parameter({ value: null })).toEqual({ name: "p", value: null });
  expect(parameter({ type: { optional: "number" } })).toEqual({ name: "p", value: null, type: { optional: "number" } });
  expect(parameter({ type: "string", doc: "Why" })).toEqual({ name: "p", type: "string", doc: "Why" });
});

test("a range has steps that can be hit", () => {
  const step = (min: number, max: number, type: Type = "number") => (parameter({ min, max, type }) as { readonly meta: { readonly step?: number } }).meta.step;
  expect([step(0, 1), step(5, 80), step(0, 0.11), step(-180, 180)]).toEqual([0.01, 1, 0.002, 5]);
  expect([step(0, 9, "int"), step(1, 1), step(2, 1), step(-1.7e308, 1.7e308), step(0, 5e-324)]).toEqual([undefined, undefined, undefined, undefined, undefined]);
});

test("what only stops, what a button holds, and what code cannot call is not offered", () => {
  expect(names([{ name: "a" }, { name: "halt", safe: true }, { name: "jog", held: true, moves: true }, { name: "b", reads: true }, { name: "pace", paces: true, moves: true }])).toEqual(["a", "b", "pace"]);
  expect(names([{ name: "in" }, { name: "None" }, { name: "__call" }, { name: "_call" }, { name: "p", parameters: [{ name: "from" }] }, { name: "result" }])).toEqual(["_call", "result"]);
  expect([names([{ name: "a" }], "for"), names([{ name: "a" }], "__s"), names([{ name: "a" }], "_")]).toEqual([[], [], ["a"]]);
});

test("the name of a state is one, whatever the names are of which it is made", () => {
  const nameFor = (key: string, name: string) => operationState(serviceOf(key, [{ name }]), { name })["state"];
  expect([nameFor("my_gripper", "move_to"), nameFor("g", "moveTo"), nameFor("_", "_"), nameFor("_1", "x")]).toEqual(["MyGripperMoveTo", "GMoveTo", "Call", "Call1X"]);
  expect(nameFor("k".repeat(64), "x")).toHaveLength(64);
});

test("only a motion is stopped, by each stop that needs no argument", () => {
  const exit = (moves: boolean, further: Partial<RsmOperation> = {}) => {
    const operation = { name: "go", moves, ...further };
    return operationState(serviceOf("s", [operation, { name: "halt", safe: true }, { name: "fade", safe: true, parameters: [{ name: "s", value: 1 }] }, { name: "end", safe: true, parameters: [{ name: "how" }] }]), operation)["exit"];
  };
  expect(exit(true)).toBe("if not available(svc.s.go.result) and not available(svc.s.go.error):\n    svc.s.halt()\n    svc.s.fade()");
  expect([exit(false), exit(true, { paces: true })]).toEqual([undefined, undefined]);
});

test("RACE-Pro adds the state under a free name, with ids, and declares its service, in one change that undo takes back", () => {
  const command = addOperation(emptyApp, placeIn(emptyApp, "root"), gripper, firstOf(gripper), newIds());
  const once = after(command, emptyApp);
  expect(once.fields["services"]).toEqual({ my_gripper: "my_gripper" });
  const [id = ""] = listOf(once, "root", "children");
  expect("select" in command && command.select).toBe(id);
  expect(elementOf(once, "root").fields["first"]).toBe("MyGripperMove");
  const ids = newIds();
  const moreIds = () => `more-${ids()}`;
  const twice = after(addOperation(once, placeIn(once, "root"), gripper, firstOf(gripper), moreIds), once);
  expect(listOf(twice, "root", "children").map((child) => elementOf(twice, child).fields["state"])).toEqual(["MyGripperMove", "MyGripperMove2"]);
  if ("reason" in command || !("operations" in command.change)) throw new Error("it is no change of operations");
  const applied = apply(emptyApp, { operations: plain<readonly Operation[]>(command.change.operations) });
  if (!("tree" in applied)) throw applied;
  const undone = apply(applied.tree, applied.inverse);
  expect("tree" in undone && documentText(undone.tree)).toBe(textOf(emptyJson));
});

test("RACE-Pro does not add it where the key stands for another type, or nothing can be inside", () => {
  const other = treeOf({ rcm: 1, services: { my_gripper: "wsg50" }, root: { state: "R", meta: { id: "root" } } });
  expect(reasonOf(addOperation(other, placeIn(other, "root"), gripper, firstOf(gripper), newIds()))).toBe("the service my_gripper is another one here: `wsg50`, not `my_gripper`");
  expect(reasonOf(addOperation(emptyApp, { reason: "no" }, gripper, firstOf(gripper), newIds()))).toBe("no");
});

test("all that its texts name is there", () => {
  const operation: RsmOperation = { name: "go", moves: true, parameters: [{ name: "to", type: "pose" }, { name: "par", value: 1 }], result: { record: { q: { list: "number" }, e: "string" } } };
  const service = serviceOf("s", [operation, { name: "halt", safe: true }]);
  const tree = after(addOperation(emptyApp, placeIn(emptyApp, "root"), service, operation, newIds()), emptyApp);
  const [state = ""] = listOf(tree, "root", "children");
  const texts = [
    ...(["entry", "exit"] as const).map((field) => ({ id: state, field })),
    ...listOf(tree, state, "actions").flatMap((id) => (["when", "do"] as const).map((field) => ({ id, field }))),
    ...listOf(tree, state, "ports").map((id) => ({ id, field: "when" as const })),
  ];
  expect(texts).toHaveLength(8);
  for (const place of texts) {
    const text = elementOf(tree, place.id).fields[place.field];
    expect(typeof text === "string" ? mistakesIn(text, scopeOf(tree, place, [service])) : place).toEqual([]);
  }
});

test("a long description does not make the edit too long for the server", () => {
  const operation: RsmOperation = { name: "go", doc: "d".repeat(60_000), parameters: [{ name: "p", doc: "d".repeat(60_000) }] };
  const command = addOperation(emptyApp, placeIn(emptyApp, "root"), serviceOf("s", [operation]), operation, newIds());
  expect("change" in command && writeExact(command.change).length < kMaxMessageBytes).toBe(true);
});
