// The rows of the proofs of a macro step: what is open at first, folding, and the way from one row to the next.
import { describe, expect, it } from "vitest";
import type { Derivation } from "../../generated/messages";
import { kAsFirst, nextNode, placeProofs, proofRows, rowOf, turn } from "../../shared/derivation/proofRows";

const node = (rule: string, ...premises: Derivation[]): Derivation => ({ rule, equation: "3.1", at: "R", premises });

/** Micro - PTrans1 - (Cond - Resolve, SAct1) */
const proof = node("Micro", node("PTrans1", node("Cond", node("Resolve")), node("SAct1")));

const rules = (rows: ReturnType<typeof proofRows>) => rows.map((row) => `${"-".repeat(row.path.length)}${row.node.rule}`);

describe("proofRows", () => {
  it("has the nodes open at which something happens, in pre-order", () => {
    expect(rules(proofRows(proof, kAsFirst))).toEqual(["Micro", "-PTrans1", "--Cond", "--SAct1"]);
    expect(rules(proofRows(proof, { all: true, turned: new Set() }))).toEqual(["Micro", "-PTrans1", "--Cond", "---Resolve", "--SAct1"]);
  });

  it("says of each its place among its siblings, and whether it is open", () => {
    const [root, trans, cond, act] = proofRows(proof, kAsFirst);
    expect(root).toMatchObject({ key: "", position: 1, siblings: 1, open: true });
    expect(trans).toMatchObject({ key: "0", open: true });
    expect(cond).toMatchObject({ key: "0.0", position: 1, siblings: 2, open: false });
    expect(act).toMatchObject({ key: "0.1", position: 2, siblings: 2, open: undefined });
  });

  it("turns a node, and back", () => {
    const unfolded = turn(kAsFirst, "0.0");
    expect(rules(proofRows(proof, unfolded))).toContain("---Resolve");
    expect(rules(proofRows(proof, turn(unfolded, "0.0")))).toEqual(rules(proofRows(proof, kAsFirst)));
    expect(rules(proofRows(proof, turn({ all: true, turned: new Set() }, "0")))).toEqual(["Micro", "-PTrans1"]);
  });
});

describe("placeProofs", () => {
  const rows = proofRows(proof, kAsFirst);
  const { places, count } = placeProofs([rows, rows]);

  it("puts proofs below each other, each with a title, with an empty row between them", () => {
    expect(places.map((place) => place.start)).toEqual([0, 6]);
    expect(count).toBe(11);
    expect(placeProofs([])).toEqual({ places: [], count: 0 });
  });

  it("finds the row of a node that is seen", () => {
    expect(rowOf(places, { micro: 0, key: "" })).toBe(1);
    expect(rowOf(places, { micro: 1, key: "0.1" })).toBe(10);
    expect(rowOf(places, { micro: 1, key: "0.0.0" })).toBeUndefined();
    expect(rowOf(places, { micro: 2, key: "" })).toBeUndefined();
  });

  it("goes from node to node, over the end of a proof, and no further than the ends of the list", () => {
    expect(nextNode(places, { micro: 0, key: "0" }, 1)).toEqual({ micro: 0, key: "0.0" });
    expect(nextNode(places, { micro: 0, key: "0.1" }, 1)).toEqual({ micro: 1, key: "" });
    expect(nextNode(places, { micro: 1, key: "" }, -1)).toEqual({ micro: 0, key: "0.1" });
    expect(nextNode(places, { micro: 0, key: "" }, -1)).toBeUndefined();
    expect(nextNode(places, { micro: 1, key: "0.1" }, 1)).toBeUndefined();
  });
});
