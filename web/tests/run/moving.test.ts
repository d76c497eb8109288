import { describe, expect, it } from "vitest";
import { movedBy, movesText } from "../../shared/run/moving";
import type { State } from "../../shared/model/model";

const state = (name: string, more: Partial<State> = {}): State => ({ kind: "state", name, parameters: [], results: [], variables: [], actions: [], children: [], ports: [], ...more });
const described = (key: string, type: string, operations: readonly { readonly name: string; readonly moves?: boolean }[]) => ({ key, type, rsm: { rsm: 1 as const, name: type, operations, events: [], states: [], transitions: [] } });
const services = [
  described("robot", "robot", [{ name: "move", moves: true }, { name: "stop" }]),
  described("gripper", "gripper", [{ name: "grasp", moves: true }]),
  described("timer", "timer", [{ name: "start" }]),
] as const;
const moved = (root: State, declared: Readonly<Record<string, string>> = {}) => movedBy({ root, services: declared }, services);

describe("what a run moves", () => {
  it("is what it calls, anywhere in its states", () => {
    const grasp = state("Grasp", { exit: "svc.gripper.grasp()" });
    expect(moved(state("Root", { children: [state("A", { children: [grasp] })], actions: [{ when: "True", do: "svc.robot.move(p)" }] }))).toEqual(["gripper", "robot"]);
  });
  it("is nothing where it only listens, waits or stops", () => {
    expect(moved(state("Root", { entry: "svc.timer.start(1)", exit: "svc.robot.stop()", ports: [{ name: "felt", when: "svc.robot.robot_state" }] }))).toEqual([]);
  });
  it("may be any that has the operation, if the service is computed", () => {
    expect(moved(state("Root", { entry: "svc[par.arm].move(p)" }))).toEqual(["robot"]);
  });
  it("is the service of the type that the document declares for another key", () => {
    expect(moved(state("Root", { entry: "svc.left.move(p)" }), { left: "robot" })).toEqual(["robot"]);
    expect(moved(state("Root", { entry: "svc.left.move(p)" }))).toEqual([]);
  });
  it("is not known while the model, or the services, are not here", () => {
    expect(movedBy(undefined, services)).toBeUndefined();
    expect(movedBy({ root: state("Root"), services: {} }, [])).toBeUndefined();
    expect(movedBy({ root: state("Root"), services: {} }, services)).toEqual([]);
  });
  it("is told", () => {
    expect(movesText(["gripper", "robot"])).toBe("This moves `gripper` and `robot`.");
    expect(movesText(undefined)).toContain("may move");
  });
});
