import { describe, expect, it } from "vitest";
import { apply, type Operation } from "../../../shared/edit/apply";
import { difference, outermostOf, type Difference, type FieldChange } from "../../../shared/edit/difference/difference";
import { reordered } from "../../../shared/edit/difference/order";
import { differenceRows } from "../../../shared/edit/difference/rows";
import { isSame } from "../../../shared/edit/difference/same";
import { Refusal } from "../../../shared/edit/refusal";
import { elementOf, listOf, type Element, type Tree } from "../../../shared/edit/tree";
import type { JsonObject, JsonValue } from "../../../shared/json";
import { document } from "../commands/fixture";
import { documentText, treeOf } from "../documents";
import { randomOf, setting } from "../random";
import { RandomEdits } from "../randomEdits";

function edited(...operations: readonly Operation[]): Tree {
  const result = apply(document, { operations });
  if (result instanceof Refusal) throw result;
  return result.tree;
}
const found = (...operations: readonly Operation[]) => difference(document, edited(...operations));
const rows = (after: Tree) => differenceRows(document, after, difference(document, after)).map(({ kind, name, text }) => `${kind} ${name}${text === "" ? "" : `: ${text}`}`);
const kNone: Difference = { added: [], removed: [], moved: [], changed: [], document: [] };

describe("the difference of two trees", () => {
  it("is nothing between a tree and itself, read again", () => {
    expect(difference(document, document)).toEqual(kNone);
    expect(difference(document, treeOf(JSON.parse(documentText(document)) as JsonValue))).toEqual(kNone);
  });

  it("has what was added and removed, with all in it", () => {
    const node = { state: "New", meta: { id: "new" }, ports: [{ name: "p", when: "True", meta: { id: "new-p" } }] };
    expect(found({ op: "insert", parent: "root", list: "children", after: "b", node })).toEqual({ ...kNone, added: ["new", "new-p"] });
    const after = found({ op: "remove", id: "c" });
    expect(after).toEqual({ ...kNone, removed: ["c", "d", "d-done", "e"] });
    expect(outermostOf(document, after.removed)).toEqual(["c"]);
  });

  it("names a field that changed, that came and that went; of meta, layout, services and notes each entry", () => {
    const after = found(
      { op: "set", id: "a-done", field: "when", value: "False" },
      { op: "set", id: "a-done", field: "to" },
      { op: "set", id: "a", field: "entry", value: "var.x = 1" },
      { op: "set", id: "a", field: "meta", key: "title", value: "T" },
      { op: "set", id: "", field: "layout", key: "a", value: { x: 1, y: 2 } },
      { op: "set", id: "", field: "services", key: "gripper", value: "wsg50" },
      { op: "set", id: "", field: "notes", key: "a", value: "why" },
    );
    expect(after.changed).toEqual([
      { id: "a", fields: [{ field: "meta", key: "title", before: undefined, after: "T" }, { field: "entry", before: undefined, after: "var.x = 1" }] },
      { id: "a-done", fields: [{ field: "when", before: "True", after: "False" }, { field: "to", before: "B", after: undefined }] },
    ]);
    expect(after.document).toEqual([
      { field: "layout", key: "a", before: undefined, after: { x: 1, y: 2 } },
      { field: "services", key: "gripper", before: undefined, after: "wsg50" },
      { field: "notes", key: "a", before: undefined, after: "why" },
    ]);
  });

  it("says of a list in another order only what was moved", () => {
    expect(found({ op: "move", id: "a", parent: "root", list: "children", after: "l" }).moved).toEqual(["a"]);
    expect(found({ op: "move", id: "b", parent: "c", list: "children" }).moved).toEqual(["b"]);
    expect(reordered(["a", "b", "c", "d", "e"], ["e", "a", "c", "d", "b"])).toEqual(["e", "b"]);
    expect(reordered(["a", "b"], ["x", "a", "y", "b"])).toEqual([]);
  });

  it("takes two documents that have nothing in common", () => {
    const other = treeOf({ rcm: 1, root: { state: "Other", meta: { id: "other" } } });
    const all = difference(document, other);
    expect([all.added, all.removed.length, all.moved, all.changed]).toEqual([["other"], document.elements.size, [], []]);
  });

  it("knows that the order of entries says nothing, and that of lists does", () => {
    expect(isSame({ a: 1, b: [1, { c: null }] }, { b: [1, { c: null }], a: 1 })).toBe(true);
    expect([isSame([1, 2], [2, 1]), isSame({ a: 1 }, { b: 1 }), isSame([], {}), isSame(null, undefined), isSame({ constructor: 1 }, {}), isSame({ a: 1 }, { a: 1, b: 1 })]).toEqual([false, false, false, false, false, false]);
  });
});

describe("a difference in words", () => {
  it("has a row for each element, not for what came or went with it", () => {
    const after = edited(
      { op: "remove", id: "c" },
      { op: "insert", parent: "root", list: "variables", node: { name: "n", initial: 1, meta: { id: "n" } } },
      { op: "set", id: "a-done", field: "when", value: "var.n > 0" },
      { op: "move", id: "b", parent: "root", list: "children" },
    );
    expect(rows(after)).toEqual(["added variable n of Root", "removed state Root/C", "moved state Root/B: in another order", "changed port Root/A.done: when: True → var.n > 0"]);
  });

  it("says both of what was moved and changed, and leaves out where things are drawn", () => {
    const after = edited({ op: "move", id: "e", parent: "root", list: "children" }, { op: "set", id: "e", field: "doc", value: "d".repeat(80) }, { op: "set", id: "", field: "layout", key: "a", value: { x: 1, y: 1 } });
    expect(rows(after)).toEqual([expect.stringMatching(/^changed state Root\/E: was in Root\/C, doc: 'd{58}…$/)]);
    expect(rows(edited({ op: "set", id: "", field: "services", key: "arm", value: "panda" }))).toEqual(["changed the document: services arm: 'panda'"]);
  });

  it("names states of the library and actions", () => {
    const after = edited({ op: "set", id: "pick-done", field: "when", value: "False" }, { op: "insert", parent: "a", list: "actions", node: { when: "True", do: "var.n = 1", meta: { id: "act" } } });
    expect(rows(after)).toEqual(["added action 1 of Root/A", "changed port library/Pick.done: when: True → False"]);
  });
});

/** `before`, made into what `after` is by what the difference names, and by nothing else. */
function rebuilt(before: Tree, after: Tree, { added, removed, moved, changed, document: about }: Difference): Tree {
  const gone = new Set([...removed, ...moved]);
  const come = new Set([...added, ...moved]);
  /** What stayed in the order of `before`, what came where `after` has it. */
  const listed = (old: readonly string[], now: readonly string[]): readonly string[] => {
    const stayed = old.filter((id) => !gone.has(id))[Symbol.iterator]();
    const list = now.map((id) => (come.has(id) ? id : String(stayed.next().value)));
    return [...list, ...stayed];
  };
  const set = (fields: JsonObject, changes: readonly FieldChange[]): JsonObject =>
    changes.reduce<JsonObject>((now, { field, key, after: value }) => {
      const entry = key === undefined ? [] : [key];
      return put(now, field === "notes" ? ["meta", "notes", ...entry] : [field, ...entry], value);
    }, fields);
  const ids = new Set([...before.elements.keys(), ...added].filter((id) => !removed.includes(id)));
  const elements = new Map([...ids].map((id): [string, Element] => {
    const was = before.elements.get(id);
    const is = elementOf(after, id);
    if (was === undefined) return [id, is];
    const names = new Set([...Object.keys(was.lists), ...Object.keys(is.lists)]) as ReadonlySet<keyof Element["lists"]>;
    const lists = Object.fromEntries([...names].map((name) => [name, listed(listOf(before, id, name), listOf(after, id, name))] as const).filter(([, all]) => all.length > 0));
    const { parent, list } = moved.includes(id) ? is : was;
    return [id, { ...was, parent, list, lists, fields: set(was.fields, changed.find((each) => each.id === id)?.fields ?? []) }];
  }));
  return { fields: set(before.fields, about), root: before.root, library: listed(before.library, after.library), elements };
}

function put(object: JsonObject, [key = "", ...rest]: readonly string[], value: JsonValue | undefined): JsonObject {
  const { [key]: old, ...others } = object;
  const inner = rest.length === 0 ? value : put((old ?? {}) as JsonObject, rest, value);
  const isGone = inner === undefined || (rest.length > 0 && Object.keys(inner as JsonObject).length === 0);
  return isGone ? others : { ...others, [key]: inner };
}

describe("random edits", () => {
  it("are the difference, all of it, and no more", () => {
    const random = randomOf(setting("RACE_SEED", 20261125));
    const edits = new RandomEdits(random, "r");
    let trees: readonly Tree[] = [document];
    for (let i = 0; i < 400; ++i) {
      const last = trees.at(-1) ?? document;
      const result = apply(last, edits.edit(last));
      if (!(result instanceof Refusal)) trees = [...trees, result.tree];
    }
    expect(trees.length).toBeGreaterThan(100);
    for (let i = 0; i < 150; ++i) {
      const [before, after] = [random.of(trees), random.of(trees)];
      const all = difference(before, after);
      expect(documentText(rebuilt(before, after, all))).toBe(documentText(after));
      for (const { id, fields } of all.changed) for (const each of fields) expect(isSame(each.before, each.after), `${id} ${each.field}`).toBe(false);
      const both = new Set(before.elements.keys());
      expect([...all.moved, ...all.changed.map(({ id }) => id)].every((id) => both.has(id) && after.elements.has(id))).toBe(true);
      expect(differenceRows(before, after, all).every(({ name }) => name !== "")).toBe(true);
    }
  });
});
