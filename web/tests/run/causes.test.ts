import { describe, expect, it } from "vitest";
import type { Derivation, TraceStep } from "../../generated/messages";
import { lastInference, type MicroStep } from "../../shared/derivation/proof";
import type { Port, State } from "../../shared/model/model";
import { buildTree } from "../../shared/model/modelTree";
import { causes } from "../../shared/run/causes";
import { caseNames, modelOf, runOf } from "../conformance";

const state = (name: string, ports: readonly Port[], children: readonly State[] = []): State => ({ kind: "state", name, parameters: [], results: [], variables: [], actions: [], children, ports });
const tree = buildTree(
  state("Root", [{ name: "error", when: "chi.Pick.port.error or chi.Place.port.error" }], [
    state("Pick", [{ name: "error", when: "chi.Grasp.port.error", to: "Place" }], [state("Grasp", [{ name: "error", when: "svc.gripper.grasp.error" }])]),
    state("Place", [{ name: "error", after: "2.5" }]),
  ]),
);
const fires = (address: string): Derivation => {
  const [at, port] = address.split(".");
  return { rule: "PTrigger", equation: "3.27", at: at ?? "", port: port ?? "", premises: [] };
};
const step = (number: number, ...ports: readonly string[]): TraceStep => ({ step: number, input: { kind: "response", service: "gripper", operation: "grasp", error: "empty", call: 4 }, micro: ports.map(fires), calls: [] });

const order = ({ step, micro }: MicroStep): number => step * 1e6 + micro;

describe("the causes of an end", () => {
  it("lead from the root to the port that reads what came from outside", () => {
    const found = causes(tree, [step(3, "Root/Pick/Grasp.error", "Root/Pick.error", "Root.error")], "Root.error");
    expect(found.map(({ address, firing }) => [address, firing])).toEqual([
      ["Root.error", { step: 3, micro: 2 }],
      ["Root/Pick.error", { step: 3, micro: 1 }],
      ["Root/Pick/Grasp.error", { step: 3, micro: 0 }],
    ]);
    expect(found.at(-1)).toMatchObject({ condition: "svc.gripper.grasp.error", input: { kind: "response", error: "empty" } });
  });
  it("are of the child that fired last, and not after its parent", () => {
    const steps = [step(2, "Root/Pick/Grasp.error", "Root/Pick.error"), step(5, "Root/Place.error", "Root.error"), step(6, "Root/Pick.error")];
    expect(causes(tree, steps, "Root.error").map(({ address, condition }) => [address, condition])).toEqual([
      ["Root.error", "chi.Pick.port.error or chi.Place.port.error"],
      ["Root/Place.error", "after 2.5 s"],
    ]);
  });
  it("end where the derivations are not here", () => {
    expect(causes(tree, [], "Root.error")).toEqual([]);
    expect(causes(tree, [step(9, "Root.error")], "Root.error").map(({ address }) => address)).toEqual(["Root.error"]);
  });
  it.each(caseNames)("of the recorded run of %s are inside each other, each before the one that it caused", (name) => {
    const { root } = modelOf(name);
    const steps = runOf(name).steps.map(({ micro, calls }, i): TraceStep => ({ step: i + 1, input: { kind: "start" }, micro, calls }));
    for (const port of root.ports) {
      const chain = causes(buildTree(root), steps, `${root.name}.${port.name}`);
      chain.slice(1).forEach(({ address, firing }, i) => {
        const outer = chain[i];
        expect(address.startsWith(`${outer?.address.slice(0, outer.address.lastIndexOf(".")) ?? "none"}/`)).toBe(true);
        expect(order(firing)).toBeLessThanOrEqual(order(outer?.firing ?? { step: 0, micro: 0 }));
        expect(lastInference(steps, { port: address })).toEqual(firing);
      });
    }
  });
});
