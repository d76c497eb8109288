import { describe, expect, it } from "vitest";
import type { Derivation, TraceStep } from "../../generated/messages";
import type { Barrier, Port, State } from "../../shared/model/model";
import { buildTree } from "../../shared/model/modelTree";
import { faultCauses, faultPlaces } from "../../shared/run/faultCauses";

const state = (name: string, more: Partial<State> = {}): State => ({ kind: "state", name, parameters: [], results: [], variables: [], actions: [], children: [], ports: [], ...more });
const to = (name: string, target: string, when = "True"): Port => ({ name, when, to: target });
const both: Barrier = { kind: "barrier", name: "Both", to: ["Place"] };
const place = state("Place", {
  first: "Divide",
  children: [
    state("Divide", {
      parameters: [{ name: "speed", from: "var.n / 2" }, { name: "fixed", value: 1 }],
      entry: "var.n = 1\nvar.n = 1 / 0",
      exit: "var.n = 3",
      actions: [{ when: "evt.timer.tick", do: "var.n = var.n % 0" }],
      ports: [{ name: "done", when: "var.n > 1" }, { name: "late", after: "1 / var.n" }],
    }),
  ],
});
const pick = state("Pick", { children: [state("Grasp", { ports: [{ name: "held", when: "svc.gripper.grasp.result" }] })], ports: [to("success", "Both", "chi.Grasp.port.held")] });
const tree = buildTree(state("Root", { children: [pick, state("Look", { ports: [to("seen", "Both")] }), both, place, state("Again", { ports: [to("retry", "Place")] })] }));

const fires = (address: string): Derivation => {
  const [at = "", port = ""] = address.split(".");
  return { rule: "PTrigger", equation: "3.27", at, port, premises: [] };
};
const step = (number: number, ...ports: readonly string[]): TraceStep => ({ step: number, input: { kind: "start" }, micro: ports.map(fires), calls: [] });

describe("what led to a fault", () => {
  it("is the port by which a state around it was entered last, through a barrier too, and what caused that", () => {
    const steps = [step(1, "Root/Look.seen"), step(2, "Root/Pick/Grasp.held", "Root/Pick.success")];
    expect(faultCauses(tree, steps, "Root/Place/Divide").map(({ address, firing }) => [address, firing])).toEqual([
      ["Root/Pick.success", { step: 2, micro: 1 }],
      ["Root/Pick/Grasp.held", { step: 2, micro: 0 }],
    ]);
    expect(faultCauses(tree, [...steps, step(4, "Root/Again.retry")], "Root/Place/Divide").map(({ address }) => address)).toEqual(["Root/Again.retry"]);
  });
  it("is nothing of a state that was entered with the root, or whose derivations are not here", () => {
    expect(faultCauses(tree, [step(1, "Root/Pick.success")], "Root/Look")).toEqual([]);
    expect(faultCauses(tree, [], "Root/Place/Divide")).toEqual([]);
  });
});

describe("the places of a fault in the code", () => {
  const places = (kind: "zero_division" | "value", isActive: boolean) => faultPlaces(tree, { kind, at: "Root/Place/Divide", message: "" }, isActive).map(({ part, text }) => [part, text]);
  it("are, as the state is entered, its parameters and entry; else the rest", () => {
    expect(places("value", false)).toEqual([["parameter", "speed ← var.n / 2"], ["entry", "var.n = 1 …"]]);
    expect(places("value", true)).toEqual([["action", "[evt.timer.tick] var.n = var.n % 0"], ["port", "var.n > 1"], ["port", "after (1 / var.n) s"], ["exit", "var.n = 3"]]);
  });
  it("are those that divide, if the fault is a division by zero", () => {
    expect(places("zero_division", true)).toEqual([["action", "[evt.timer.tick] var.n = var.n % 0"], ["port", "after (1 / var.n) s"]]);
    expect(places("zero_division", false)).toEqual([["parameter", "speed ← var.n / 2"], ["entry", "var.n = 1 / 0"]]);
    expect(faultPlaces(tree, { kind: "zero_division", at: "Root/Pick", message: "" }, true)).toHaveLength(1);
  });
  it("are none of a barrier", () => expect(faultPlaces(tree, { kind: "value", at: "Root/Both", message: "" }, true)).toEqual([]));
});
