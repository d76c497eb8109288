import { describe, expect, it } from "vitest";
import { readFileSync } from "node:fs";
import type { Edit } from "../../generated/messages";
import { apply, applyFitting } from "../../shared/edit/apply";
import { Refusal } from "../../shared/edit/refusal";
import { documentOf, readTree, type Tree } from "../../shared/edit/tree";
import { documentText, treeOf, vector } from "./documents";
import { randomOf, setting } from "./random";
import { RandomEdits } from "./randomEdits";
import type { JsonObject, JsonValue } from "../../shared/json";

const small = (vector("apply.remove.json") as { readonly document: JsonObject }).document;
const demo = JSON.parse(readFileSync(new URL("../../../deploy/demo/demonstrator.rcm.json", import.meta.url), "utf8")) as JsonValue;

function changed(tree: Tree, ...operations: Edit["operations"]): Tree {
  const result = apply(tree, { operations });
  if (result instanceof Refusal) throw result;
  return result.tree;
}

describe("documentOf", () => {
  it("gives the document that was read", () => {
    expect(documentOf(treeOf(small))).toEqual(small);
    expect(documentOf(treeOf(demo))).toEqual(demo);
  });
  it("shares what an edit did not change with the document before, and makes the rest anew", () => {
    const tree = treeOf(small);
    const before = documentOf(tree);
    const after = documentOf(changed(tree, { op: "set", id: "x", field: "doc", value: "new" }));
    const [a, b, c] = before.root.children ?? [];
    const [newA, newB, newC] = after.root.children ?? [];
    expect([newA === a, newB === b, newC === c]).toEqual([true, false, true]);
    expect(after.root.parameters?.[0]).toBe(before.root.parameters?.[0]);
    expect(after.layout).toBe(before.layout);
  });
  it("shares the elements that an edit did not change", () => {
    const tree = treeOf(small);
    const after = changed(tree, { op: "move", id: "x", parent: "a", list: "children" });
    const other = [...after.elements].filter(([id, element]) => tree.elements.get(id) !== element).map(([id]) => id);
    expect(other.sort()).toEqual(["a", "b", "x"]);
  });
});

describe("readTree", () => {
  it.each([
    ["version", { rcm: 2 }],
    ["missing", { rcm: 1 }],
    ["missing", { rcm: 1, root: { state: "R" } }],
    ["type", { rcm: 1, root: { state: "R", meta: { id: "no id" } } }],
    ["duplicate", { rcm: 1, root: { state: "R", meta: { id: "r" }, ports: [{ name: "p", meta: { id: "r" } }] } }],
    ["unknown_field", { rcm: 1, root: { state: "R", meta: { id: "r" }, color: "red" } }],
  ])("refuses what no server sends: %s", (code, document) => {
    expect(readTree(document)).toMatchObject({ code });
  });
});

describe("apply", () => {
  it("takes names that objects have from birth as keys like others", () => {
    const tree = treeOf(small);
    const set = (key: string, value?: JsonValue) => ({ op: "set", id: "a", field: "meta", key, ...(value !== undefined && { value }) }) as const;
    for (const key of ["__proto__", "constructor", "toString"]) {
      const result = apply(tree, { operations: [set(key, { x: 1 })] });
      if (result instanceof Refusal) throw result;
      expect(result.inverse.operations).toEqual([set(key)]);
      expect(documentText(result.tree)).toContain(`"${key}":{"x":1}`);
      expect(documentText(changed(result.tree, ...result.inverse.operations))).toBe(documentText(tree));
    }
  });
  it("refuses what would be deeper than a text may be", () => {
    const nested = (levels: number): JsonValue => (levels === 0 ? 1 : [nested(levels - 1)]);
    const result = (levels: number) => apply(treeOf(small), { operations: [{ op: "set", id: "p", field: "value", value: nested(levels) }] });
    expect(result(60)).not.toBeInstanceOf(Refusal);
    expect(result(61)).toMatchObject({ code: "too_deep", path: "operations/0/value" });
  });
  it("gives the same document again when random edits are taken back, whatever was refused", () => {
    const seed = setting("RACE_SEED", 20261122);
    let accepted = 0;
    let refused = 0;
    for (const document of [small, demo]) {
      const edits = new RandomEdits(randomOf(seed), "n");
      const first = treeOf(document);
      const inverses: Edit[] = [];
      let tree = first;
      for (let i = 0; i < 300; ++i) {
        const before = documentOf(tree);
        const result = apply(tree, edits.edit(tree));
        expect(documentOf(tree).root).toBe(before.root);
        if (result instanceof Refusal) {
          ++refused;
          continue;
        }
        ++accepted;
        inverses.push(result.inverse);
        tree = result.tree;
        if (i % 20 === 0) expect(documentText(treeOf(documentOf(tree) as unknown as JsonValue))).toBe(documentText(tree));
      }
      for (const inverse of inverses.reverse()) tree = changed(tree, ...inverse.operations);
      expect(documentText(tree)).toBe(documentText(first));
    }
    expect(accepted).toBeGreaterThan(refused);
    expect(refused).toBeGreaterThan(20);
  });
});

describe("several edits at once", () => {
  it("give what one after the other gives, those that are refused left out", () => {
    const random = randomOf(setting("RACE_SEED", 20261126));
    const edits = new RandomEdits(random, "f-");
    let refused = 0;
    for (let i = 0; i < 60; ++i) {
      const start = treeOf(random.chance(0.5) ? small : demo);
      // Made on the tree at the start, so that many do not fit any more.
      const many = Array.from({ length: 1 + random.pick(20) }, () => edits.edit(start));
      const expected = many.reduce((tree, edit) => {
        const result = apply(tree, edit);
        if (!(result instanceof Refusal)) return result.tree;
        ++refused;
        return tree;
      }, start);
      expect(documentText(applyFitting(start, many))).toBe(documentText(expected));
    }
    expect(refused).toBeGreaterThan(20);
  });
  it("that are all refused leave the tree as it is", () => {
    const tree = treeOf(small);
    expect(applyFitting(tree, [{ operations: [{ op: "set", id: "a", field: "doc", value: "new" }, { op: "remove", id: "none" }] }])).toBe(tree);
  });
});
