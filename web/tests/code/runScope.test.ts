import { describe, expect, it } from "vitest";
import { mistakesIn } from "../../shared/code/mistakes";
import { runScope } from "../../shared/code/runScope";
import { buildTree } from "../../shared/model/modelTree";
import type { State } from "../../shared/model/model";
import { caseNames, modelOf } from "../conformance";

const state = (name: string, more: Partial<State> = {}): State => ({ kind: "state", name, parameters: [], results: [], variables: [], actions: [], children: [], ports: [], ...more });
const pick = state("Pick", {
  parameters: [{ name: "key" }],
  variables: [{ name: "n" }],
  entry: "var.free = 1",
  children: [state("Grasp", { results: [{ name: "held" }], ports: [{ name: "success", when: "True" }] }), { kind: "barrier", name: "Both", to: [] }],
  ports: [{ name: "late", after: "1.0" }],
});
const wrong = (text: string) => mistakesIn(text, runScope(pick, { hand: "wsg50" }, [])).map(({ message }) => message);

describe("the names for a condition in a run", () => {
  it("are those of the state", () => {
    expect(wrong("par.key == 1 and var.n > 0 and var.free == 1 and chi.Grasp.res.held and chi.Grasp.port.success and chi.Both.active and port.late and svc.hand.grasp.result")).toEqual([]);
    expect(wrong("par.kee == 1")).toEqual(["kee is not declared here"]);
    expect(wrong("chi.Grip.active")).toEqual(["there is no child Grip"]);
    expect(wrong("chi.Grasp.port.sucess")).toEqual(["sucess is not declared here"]);
  });
  it("are also those of the children that a time-out makes", () => expect(wrong("chi.After_late.active and chi.After.active")).toEqual([]));

  it("let all conditions of the conformance models be", () => {
    for (const name of caseNames)
      for (const { node } of buildTree(modelOf(name).root).values())
        if (node.kind === "state") for (const { when } of [...node.actions, ...node.ports]) expect(mistakesIn(when ?? "", runScope(node, modelOf(name).services, [])), `${name} ${node.name}: ${when}`).toEqual([]);
  });
});
