import { describe, expect, it } from "vitest";
import { clip, describeState, valueText } from "../../shared/model/describe";
import { foldedAtFirst } from "../../shared/model/folding";
import { exitReferences, exitsThrough } from "../../shared/model/exitReferences";
import type { State } from "../../shared/model/model";
import { ancestry, buildTree, inboundPorts, portAt, splitAddress, stateAt } from "../../shared/model/modelTree";
import { search } from "../../shared/model/search";
import { caseNames, modelOf } from "../conformance";

const collision = buildTree(modelOf("thesis-collision-history").root);

describe("models", () => {
  it.each(caseNames)("%s is read, and every node is found under its path", (name) => {
    const tree = buildTree(modelOf(name).root);
    for (const [path, entry] of tree) {
      expect(path.split("/").length).toBe(entry.depth + 1);
      expect(entry.parent === undefined || tree.has(entry.parent)).toBe(true);
    }
  });
  it("address ports by path and name", () => {
    expect(portAt(collision, "Root/Pick/Grasp.error")?.to).toBe("Retreat");
    expect(portAt(collision, "Root/Pick/Grasp.nothing")).toBeUndefined();
    expect(splitAddress("Root/A.b")).toEqual({ path: "Root/A", port: "b" });
    expect(ancestry("Root/Pick/Grasp")).toEqual(["Root", "Root/Pick", "Root/Pick/Grasp"]);
  });
  it("know the ports that lead to a barrier, in declaration order", () => {
    const join = buildTree(modelOf("barrier-join").root);
    const barrier = [...join.values()].find((entry) => entry.node.kind === "barrier" && inboundPorts(join, entry.path).length > 1);
    expect(barrier).toBeDefined();
    for (const port of inboundPorts(join, barrier?.path ?? "")) expect(portAt(join, port)?.to).toBe(barrier?.node.name);
  });
});

describe("exitsThrough", () => {
  const port = (name: string, when: string) => ({ name, when });
  const parent = { ports: [port("done", "chi.A.port.ok and chi.B.port.ok"), port("failed", "chi.A.port.failed"), { name: "late", after: "3" }] } as unknown as State;
  it("names the ports of the state around that read a port of a child", () => {
    expect(exitsThrough(parent, "A", "ok")).toEqual(["done"]);
    expect(exitsThrough(parent, "B", "failed")).toEqual([]);
    expect(exitsThrough(undefined, "A", "ok")).toEqual([]);
  });
});

describe("exitReferences", () => {
  it("finds each child port that a condition names, once", () => {
    const when = "chi.Haptic.port.success or chi.Display.port.success and chi.Haptic.port.success";
    expect(exitReferences(when)).toEqual([
      { child: "Haptic", port: "success" },
      { child: "Display", port: "success" },
    ]);
  });
  it("does not look into string literals", () => {
    expect(exitReferences("par.text == 'chi.A.port.b' and chi.C.port.d")).toEqual([{ child: "C", port: "d" }]);
  });
  it("does not take results or longer names for ports", () => {
    expect(exitReferences("chi.A.res.port and machi.A.port.x")).toEqual([]);
  });
});

describe("the text section of a state", () => {
  const grasp = stateAt(collision, "Root/Pick/Grasp");
  it("names parameters, results, functions and actions in this order (Fig. 3.2, 3.3)", () => {
    expect(grasp === undefined ? [] : describeState(grasp).map((line) => line.label)).toEqual(["params", "results", "entry", "action"]);
  });
  it("shows where a parameter comes from", () => {
    expect(grasp === undefined ? "" : describeState(grasp)[0]?.text).toBe("width ← par.width");
  });
  it("writes values as a task author would", () => {
    expect(valueText({ pose: [0.4, 0, null], held: true, name: "x" })).toBe("{pose: [0.4, 0, None], held: True, name: 'x'}");
    expect(clip("abcdef", 4)).toBe("abc…");
  });
});

describe("foldedAtFirst", () => {
  it("shows a task of ordinary size whole", () => expect(foldedAtFirst(collision)).toEqual([]));
  it("folds every composite below the root of a large one", () => {
    const { root } = modelOf("thesis-collision-history");
    const pick = root.children[0];
    if (pick === undefined) throw new Error("the fixture has no children");
    const copies = Array.from({ length: 9 }, (_, i) => ({ ...pick, name: `Pick${i}` }));
    expect(foldedAtFirst(buildTree({ ...root, children: copies }))).toEqual(copies.map((copy) => `Root/${copy.name}`));
  });
});

describe("search", () => {
  it("finds names first, then code", () => {
    const hits = search(collision, "retreat");
    expect(hits[0]).toEqual({ kind: "node", target: "Root/Pick/Retreat" });
    expect(hits.some((hit) => hit.context?.includes("chi.Retreat.port.error") === true)).toBe(true);
  });
  it("ignores case and finds ports", () => {
    expect(search(collision, "COLLISION").map((hit) => hit.target)).toContain("Root/Pick.collision");
  });
  it("finds nothing for an empty query", () => expect(search(collision, "  ")).toEqual([]));
});
