import { describe, expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { check } from "../../shared/messages/check";
import { elementsById } from "../../shared/model/byId";
import { buildTree, type ModelTree } from "../../shared/model/modelTree";
import { withOracles } from "../../shared/model/oracles";
import { readModel } from "../../shared/model/readModel";
import { readJson } from "../files";

const treeOf = (document: unknown): ModelTree => buildTree(readModel(check(schema.native, { document, origin: {} }).document).root);
const identified = treeOf(readJson(new URL("../../../api/examples/document.ids.json", import.meta.url)));

describe("elementsById", () => {
  it("finds states, barriers, parameters, results, variables, actions and ports, each with the path of its node", () => {
    const found = [...elementsById(identified)].map(([id, { kind, path }]) => `${id}: ${kind} ${path}`);
    expect(found).toEqual([
      "root: state Root",
      "last: parameter Root",
      "8dTmJ0vC1_: result Root",
      "yTg7: port Root",
      "9b1deb4d-3b7d-4bad-9bdd-2b0d7b3dcb6d: state Root/Count",
      "k2-Par: parameter Root/Count",
      "x4Qo: result Root/Count",
      "x4Qn: variable Root/Count",
      "0a: action Root/Count",
      "yTg5: port Root/Count",
      "Zz: barrier Root/Both",
      "end: state Root/End",
      "yTg6: port Root/End",
    ]);
  });
  it("gives the element itself", () => {
    const port = elementsById(identified).get("yTg5");
    expect(port?.kind === "port" && port.element).toEqual({ id: "yTg5", name: "done", when: "var.n >= par.last", to: "Both" });
    expect(elementsById(identified).get("Root/Count")).toBeUndefined();
  });
  it("finds it where it is after it was renamed and moved", () => {
    const moved = treeOf({ rcm: 1, root: { state: "Root", children: [{ state: "Group", children: [{ state: "Tick", meta: { id: "count" } }] }] } });
    expect(elementsById(moved).get("count")?.path).toBe("Root/Group/Tick");
  });
  it("finds the first of elements with the same id", () => {
    const meta = { id: "twice" };
    const twice = elementsById(treeOf({ rcm: 1, root: { state: "Root", children: [{ state: "A", meta }, { state: "B", meta }] } }));
    expect([twice.size, twice.get("twice")?.path]).toEqual([1, "Root/A"]);
  });
  it.each([null, 7, "text", ["id"], { title: "Grasp" }])("takes no id from the meta %j", (meta) => {
    const tree = treeOf({ rcm: 1, root: { state: "Root", ports: [{ name: "p", when: "True", meta }], meta } });
    expect([elementsById(tree).size, tree.get("Root")?.node.id]).toEqual([0, undefined]);
  });
  it("finds a state also after its oracle was marked", () => {
    const state = identified.get("Root")?.node;
    if (state?.kind !== "state") throw new Error("the example has no root");
    const marked = withOracles(state, { Root: "Root", "Root/Count": "Root", "Root/End": "Root/End" });
    expect(elementsById(buildTree(marked)).get("9b1deb4d-3b7d-4bad-9bdd-2b0d7b3dcb6d")?.element).toMatchObject({ dispatcher: "choice" });
  });
});
