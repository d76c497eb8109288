import { describe, expect, it } from "vitest";
import { actionConflicts, childConflicts, portConflicts } from "../../shared/edit/order";
import type { Action, Barrier, Node, Port, State } from "../../shared/model/model";

const ports = (...conditions: readonly string[]): readonly Port[] => conditions.map((when, i) => ({ name: `p${i}`, when }));
const action = (when: string, code: string): Action => ({ when, do: code });
const state = (name: string, ...to: readonly string[]): State => ({
  kind: "state", name, parameters: [], results: [], variables: [], actions: [], children: [], ports: to.map((target, i) => ({ name: `p${i}`, when: "True", to: target })),
});
const barrier = (name: string, ...to: readonly string[]): Barrier => ({ kind: "barrier", name, to });
const together = (...children: readonly Node[]): readonly string[] => [...childConflicts({ ...state("Root"), children })].map((i) => children[i]?.name ?? "").sort();

describe("the order of ports matters", () => {
  it("where two may be fulfilled at once", () => expect([...portConflicts(ports("res.x > 1", "svc.robot.move.error"))]).toEqual([0, 1]));
  it("not for one alone, or one that never fires", () => {
    expect(portConflicts(ports("True")).size).toBe(0);
    expect(portConflicts(ports("res.x > 1", "False")).size).toBe(0);
  });
  it("not where the conditions exclude each other", () => {
    expect(portConflicts(ports("res.done", "not res.done")).size).toBe(0);
    expect(portConflicts(ports("res.kind == 'a'", 'res.kind == "b"', "res.kind == 'c'")).size).toBe(0);
    expect([...portConflicts(ports("res.kind == 'a'", "res.kind == 'b'", "res.kind == 'a'"))]).toEqual([0, 2]);
  });
  it("for 1 and True, and 0 and -0, which are equal", () => {
    expect(portConflicts(ports("res.x == 1", "res.x == True")).size).toBe(2);
    expect(portConflicts(ports("res.x == 0", "res.x == -0")).size).toBe(2);
  });
  it("of a time-out and a condition", () => expect(portConflicts([{ name: "late", after: "2.0" }, { name: "done", when: "res.done" }]).size).toBe(2));
  it("in the library, not in what links it", () => expect(portConflicts(ports("res.a", "res.b"), true).size).toBe(0));
});

describe("the order of actions matters", () => {
  it("where one writes what another one uses", () => {
    expect([...actionConflicts([action("True", "var.x += 1"), action("var.x > 2", "pass"), action("True", "res.y = 1")])]).toEqual([0, 1]);
    expect(actionConflicts([action("True", "var.x[0] = 1"), action("True", "print(var.x)")]).size).toBe(2);
    expect(actionConflicts([action("True", "[var.a, var.b] = par.pair"), action("var.b", "pass")]).size).toBe(2);
  });
  it("not where both only read, or a text looks like it", () => {
    expect(actionConflicts([action("var.x == 1", "pass"), action("var.x == 2", "print('var.x = 1')")]).size).toBe(0);
  });
  it("where both turn to one service", () => {
    expect(actionConflicts([action("True", "svc.robot.stop()"), action("True", "svc.robot.move()")]).size).toBe(2);
    expect(actionConflicts([action("True", "svc.robot.stop()"), action("True", "svc.timer.wait(1)")]).size).toBe(0);
    expect(actionConflicts([action("True", "svc[par.s].stop()"), action("True", "svc.timer.wait(1)")]).size).toBe(2);
  });
});

describe("the order of children matters", () => {
  it("where a barrier leads to several, up to the barrier where they meet", () => {
    expect(together(state("A", "Fork"), barrier("Fork", "B", "C"), state("B", "B2"), state("B2", "Join"), state("C", "Join"), barrier("Join", "D"), state("D"))).toEqual(["B", "B2", "C"]);
  });
  it("not where one follows another", () => expect(together(state("A", "B"), state("B", "A"))).toEqual([]));
  it("of many, in time and without recursion", () => {
    const chain = Array.from({ length: 50_000 }, (_, i) => state(`S${i}`, `S${i + 1}`));
    const forks = Array.from({ length: 1000 }, (_, i) => barrier(`F${i}`, `S${i}`, `S${i + 1}`));
    expect(together(...forks, ...chain).length).toBe(50_000);
  });
});
