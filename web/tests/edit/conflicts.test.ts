// A field that two people set at the same time: both values are kept, and either can be had.
import { describe, expect, it } from "vitest";
import type { AcceptedEdit } from "../../generated/messages";
import { apply, type Operation } from "../../shared/edit/apply";
import { changeText, withNames, writtenText } from "../../shared/edit/changeText";
import { choicesOf, conflictsWith, isField, kMoment, ownSets, type OwnSet } from "../../shared/edit/conflicts";
import { applyEditing, nothingEdited } from "../../shared/edit/editing";
import { plain, readExact, type Exact } from "../../shared/edit/exact";
import { Refusal } from "../../shared/edit/refusal";
import { refusalText } from "../../shared/edit/refusalText";
import type { Change, EditSession, Notice, PendingEdit } from "../../shared/edit/session";
import type { Tree } from "../../shared/edit/tree";
import { treeOf } from "./documents";

const ports = [{ name: "done", when: "True", to: "B", meta: { id: "p" } }];
const children = [{ state: "A", doc: "first", ports, meta: { id: "a" } }, { state: "B", parameters: [{ name: "speed", value: 0.1, meta: { id: "s" } }], meta: { id: "b" } }];
const document = treeOf({ rcm: 1, root: { state: "Root", children, meta: { id: "r" } }, layout: { a: { x: 0, y: 0 } } });

const set = (id: string, field: string, value: string | number): Operation => ({ op: "set", id, field, value });
const change = (...operations: readonly Exact<Operation>[]): Change => ({ operations });
function pendingOf(made: Change): PendingEdit {
  const operations = "operations" in made ? plain<readonly Operation[]>(made.operations) : [];
  return { request: "t", revision: 1, change: made, operations, copies: 1 };
}
const session = (...changes: readonly Change[]): Pick<EditSession, "pending" | "view"> => ({ pending: changes.map(pendingOf), view: document });
const theirs = (...operations: readonly Operation[]): AcceptedEdit => ({ document: "d", revision: 2, author: "Bob~1", message: "", time: 0, kind: "change", operations, errors: [], undo: 1, redo: 0 });
const noted = (...changes: readonly Change[]): readonly OwnSet[] => ownSets([], session(...changes), 0);

function after(tree: Tree, made: Change | undefined): Tree {
  if (made === undefined || !("operations" in made)) throw new Error("there is no edit");
  const result = apply(tree, { operations: plain<readonly Operation[]>(made.operations) });
  if (result instanceof Refusal) throw result;
  return result.tree;
}

describe("what both have set", () => {
  it("is known while the own edit waits, and for a moment after it", () => {
    const mine = change(set("a", "doc", "mine"));
    const own = noted(mine);
    expect(ownSets(own, session(mine), 1e9), "it waits").toHaveLength(1);
    expect(ownSets(own, session(), kMoment - 1)).toBe(own);
    expect(ownSets(own, session(), kMoment)).toEqual([]);
  });
  it("is the same field with another value, and no other", () => {
    const own = noted(change(set("a", "doc", "mine"), set("b", "doc", "mine")));
    expect(conflictsWith(own, theirs(set("a", "doc", "theirs")))).toMatchObject([{ id: "a", field: "doc", mine: "mine", theirs: "theirs", author: "Bob~1" }]);
    expect(conflictsWith(own, theirs(set("a", "doc", "mine")))).toEqual([]);
    expect(conflictsWith(own, theirs(set("a", "entry", "theirs"), { op: "remove", id: "b" }))).toEqual([]);
    expect(conflictsWith(own, theirs(set("a", "doc", "theirs"), set("a", "doc", "mine"))), "in the end it is the same").toEqual([]);
  });
  it("is the last of several own values", () => {
    expect(conflictsWith(noted(change(set("a", "doc", "1")), change(set("a", "doc", "2"))), theirs(set("a", "doc", "2")))).toEqual([]);
  });
  it("is not where states are drawn", () => {
    const move = (x: number): Operation => ({ op: "set", id: "", field: "layout", key: "a", value: { x, y: 0 } });
    expect(conflictsWith(noted(change(move(1))), theirs(move(2)))).toEqual([]);
  });
  it("can be set to either, the own value as it was typed", () => {
    const own = noted(change({ op: "set", id: "s", field: "value", value: readExact("2.0") }));
    const [conflict] = conflictsWith(own, theirs(set("s", "value", 0.3)));
    if (conflict === undefined) throw new Error("there is no conflict");
    const [withTheirs, withMine] = [after(document, change(set("s", "value", 0.3))), after(document, conflict.again)];
    expect(choicesOf(conflict, withTheirs)).toEqual({ holds: "theirs", mine: conflict.again, theirs: undefined });
    expect(writtenText(conflict.again)).toBe("2.0");
    expect(choicesOf(conflict, withMine).holds).toBe("mine");
    expect(choicesOf(conflict, after(withMine, choicesOf(conflict, withMine).theirs)).holds).toBe("theirs");
    expect(choicesOf(conflict, after(document, change({ op: "remove", id: "b" }))), "it is gone").toEqual({ holds: undefined, mine: undefined, theirs: undefined });
  });
  it("is not set to a number that may have been written otherwise", () => {
    const [conflict] = conflictsWith(noted(change(set("s", "value", 5))), theirs({ op: "set", id: "s", field: "value", value: { x: [1] } }));
    if (conflict === undefined) throw new Error("there is no conflict");
    expect(choicesOf(conflict, document).theirs).toBeUndefined();
  });
  it("may be a name", () => {
    const own = noted({ compound: { kind: "rename", id: "a", name: "Mine" } });
    const [conflict] = conflictsWith(own, theirs(set("a", "state", "Theirs")));
    if (conflict === undefined) throw new Error("there is no conflict");
    expect(isField(conflict, "a", "name")).toBe(true);
    expect(isField(conflict, "a", "doc")).toBe(false);
    expect(choicesOf(conflict, document)).toEqual({ holds: undefined, mine: conflict.again, theirs: { compound: { kind: "rename", id: "a", name: "Theirs" } } });
  });
  it("is told once for a field", () => {
    const [first, second] = [1, 2].map((i) => conflictsWith(noted(change(set("a", "doc", "mine"))), theirs(set("a", "doc", `${i}`)))[0]);
    if (first === undefined || second === undefined) throw new Error("there is no conflict");
    const told = [first, second].reduce((now, conflict, i) => applyEditing(now, { type: "met", text: `${i}`, conflict }), nothingEdited).told;
    expect(told.map(({ text, number }) => [text, number])).toEqual([["1", 2]]);
  });
});

describe("a change that was refused", () => {
  it("is told in words", () => {
    expect(changeText(document, change(set("p", "when", "res.x > 1")))).toBe("when of port Root/A.done: “res.x > 1”");
    expect(changeText(document, change({ op: "remove", id: "a" }, { op: "remove", id: "gone" }))).toBe("delete state Root/A; delete what is gone");
    expect(changeText(document, change(...[1, 2, 3, 4].map((i) => set("a", "doc", `${i}`))))).toContain("and 1 more");
    expect(changeText(document, { compound: { kind: "rename", id: "a", name: "X" } })).toBe("state Root/A to X");
    expect(changeText(document, { undo: true })).toBeUndefined();
    expect(withNames(document, "`a`, or what is in it, was changed; `doc` of `gone`")).toBe("state Root/A, or what is in it, was changed; `doc` of `gone`");
  });
  it("gives what it would have written: a text, or elements that can be pasted", () => {
    expect(writtenText(change(set("p", "when", "res.x > 1")))).toBe("res.x > 1");
    const node = readExact('{"state": "New", "parameters": [{"name": "w", "value": 1.0}]}');
    const inserted = writtenText(change({ op: "insert", parent: "r", list: "children", node: node as Exact<Extract<Operation, { op: "insert" }>["node"]> }));
    expect(inserted).toContain('"value": 1.0');
    expect(JSON.parse(inserted ?? "")).toMatchObject({ children: [{ state: "New" }] });
    expect(writtenText(change({ op: "remove", id: "a" }))).toBeUndefined();
  });
});

describe("why an edit was refused", () => {
  const notice = (message: string, author?: string): Notice => ({ request: "t", change: { undo: true }, errors: [{ path: "", code: "conflict", message }], ...(author !== undefined && { author, revision: 7 }) });
  it("names people as they are known", () => {
    expect(refusalText(notice("it was set by `Bob~x1` (revision 7)", "Bob~x1"))).toBe("Undo was refused: it was set by Bob (revision 7).");
    expect(refusalText(notice("it is gone", "Bob~x1"))).toBe("Undo was refused: it is gone (Bob was faster, revision 7).");
    const grouping: Notice = { request: "t", change: { compound: { kind: "group", ids: ["a"], name: "G" } }, errors: [{ path: "compound/a", code: "conflict", message: "it would be entered twice" }] };
    expect(refusalText(grouping)).toBe("Grouping was refused: it would be entered twice.");
    expect(refusalText(notice("there is nothing to undo"))).toBe("Undo was refused: there is nothing to undo.");
  });
});
