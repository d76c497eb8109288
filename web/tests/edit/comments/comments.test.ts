// Comments are threads of their elements; commands about them change what is meant, and nothing that another person writes at the same time.
import { describe, expect, it } from "vitest";
import { apply, type Operation } from "../../../shared/edit/apply";
import type { Command } from "../../../shared/edit/commands/command";
import { remove } from "../../../shared/edit/commands/remove";
import { commentsOf, isOpen, threadsOn } from "../../../shared/edit/comments/comments";
import { commentMarks } from "../../../shared/edit/comments/marks";
import { timeText } from "../../../shared/timeText";
import { answer, comment, kMaxInDocument, kMaxOnElement, kMaxText, removeComment, reopen, resolve, rewrite, type By } from "../../../shared/edit/comments/write";
import { difference } from "../../../shared/edit/difference/difference";
import { differenceRows } from "../../../shared/edit/difference/rows";
import { editedState } from "../../../shared/edit/editedModel";
import { Refusal } from "../../../shared/edit/refusal";
import { kMaxMessageBytes } from "../../../shared/edit/session";
import type { Tree } from "../../../shared/edit/tree";
import { buildTree } from "../../../shared/model/modelTree";
import { treeOf } from "../documents";

const ports = [{ name: "done", when: "True", meta: { id: "p" } }];
const inner = { state: "C", children: [{ state: "D", meta: { id: "d" } }], first: "D", meta: { id: "c" } };
const children = [{ state: "A", ports, meta: { id: "a" } }, { barrier: "B", to: ["A"], meta: { id: "b" } }, inner];
const document = treeOf({ rcm: 1, root: { state: "Root", first: "A", children, meta: { id: "r" } }, meta: { notes: { a: "a note" }, title: "mine" } });

const by = (author: string, second = 0): By => ({ author, time: `2026-11-26T01:00:${String(second).padStart(2, "0")}.000Z` });
const [ada, bob] = [by("Ada"), by("Bob", 1)];

const reasonOf = (command: Command): string | undefined => ("reason" in command ? command.reason : undefined);
const operationsOf = (command: Command): readonly Operation[] => {
  if ("reason" in command || !("operations" in command.change)) throw new Error("there is no edit");
  return command.change.operations as readonly Operation[];
};
function applied(tree: Tree, operations: readonly Operation[]) {
  const result = apply(tree, { operations });
  if (result instanceof Refusal) throw result;
  return result;
}
const after = (tree: Tree, ...commands: readonly ((tree: Tree) => Command)[]): Tree => commands.reduce((now, make) => applied(now, operationsOf(make(now))).tree, tree);

const begun = after(document, (tree) => comment(tree, "a", "1", "Why True?", ada), (tree) => answer(tree, "1", "2", "To try it", bob));

describe("comments", () => {
  it("are threads of their element, answers in the order of time", () => {
    const tree = after(begun, (now) => answer(now, "1", "0", "Then say so", by("Ada", 2)), (now) => comment(now, "d", "3", "Slow", by("Bob", 3)));
    const [thread, ...others] = threadsOn(tree, "a");
    expect(others).toEqual([]);
    expect(thread?.comment).toEqual({ id: "1", about: "a", ...ada, text: "Why True?" });
    expect(thread?.answers.map(({ id }) => id)).toEqual(["2", "0"]);
    expect(commentsOf(tree).threads.map(({ comment: { id } }) => id)).toEqual(["1", "3"]);
    expect(commentsOf(tree), "the same as long as nothing of it changed").toBe(commentsOf(applied(tree, [{ op: "set", id: "a", field: "doc", value: "x" }]).tree));
  });
  it("leave the rest of the document as it was", () => {
    expect(begun.fields["meta"]).toMatchObject({ notes: { a: "a note" }, title: "mine" });
    const taken = after(begun, (tree) => removeComment(tree, "1"));
    expect(taken.fields).toEqual(document.fields);
  });
  it("are rewritten by their author alone", () => {
    expect(reasonOf(rewrite(begun, "1", "What?", bob))).toContain("only Ada");
    expect(reasonOf(rewrite(begun, "1", "Why True?", ada))).toContain("as it was");
    const changed = after(begun, (tree) => rewrite(tree, "1", "Why always?", by("Ada", 9)));
    expect(commentsOf(changed).byId.get("1")).toMatchObject({ text: "Why always?", time: ada.time, edited: by("Ada", 9).time });
  });
  it("are resolved and reopened by anybody, also while their text is changed", () => {
    const [resolving, rewriting] = [operationsOf(resolve(begun, "1", bob)), operationsOf(rewrite(begun, "1", "Why always?", ada))];
    for (const both of [[...resolving, ...rewriting], [...rewriting, ...resolving]]) {
      const [thread] = threadsOn(applied(begun, both).tree, "a");
      expect(thread).toMatchObject({ comment: { text: "Why always?" }, resolved: { author: "Bob" } });
    }
    const resolved = applied(begun, resolving).tree;
    expect(reasonOf(resolve(resolved, "1", ada))).toContain("already");
    expect(threadsOn(after(resolved, (tree) => reopen(tree, "1")), "a").every(isOpen)).toBe(true);
  });
  it("go with the first one of their thread, and an answer that comes too late begins one", () => {
    const late = operationsOf(answer(begun, "1", "3", "Wait", by("Bob", 4)));
    const taken = after(begun, (tree) => resolve(tree, "1", ada), (tree) => removeComment(tree, "1"));
    expect(commentsOf(taken).threads).toEqual([]);
    expect(threadsOn(applied(taken, late).tree, "a")).toMatchObject([{ comment: { text: "Wait" }, answers: [] }]);
    expect(commentsOf(after(begun, (tree) => removeComment(tree, "2"))).threads).toMatchObject([{ comment: { id: "1" }, answers: [] }]);
  });
  it("go with their state and what is in it, and come back with it", () => {
    const full = after(begun, (tree) => comment(tree, "d", "3", "Slow", ada), (tree) => comment(tree, "b", "4", "Why?", ada), (tree) => resolve(tree, "4", bob));
    const { tree, inverse } = applied(full, operationsOf(remove(full, ["c", "b"])));
    expect(commentsOf(tree).threads.map(({ comment: { id } }) => id)).toEqual(["1"]);
    expect(Object.keys(tree.fields["meta"] as object).filter((key) => key.startsWith("resolved"))).toEqual([]);
    expect(commentsOf(applied(tree, inverse.operations).tree)).toEqual(commentsOf(full));
  });
  it("have bounds", () => {
    expect(reasonOf(comment(document, "a", "1", "  \n", ada))).toContain("needs a text");
    expect(reasonOf(comment(document, "a", "1", "ü".repeat(kMaxText), ada))).toBeUndefined();
    expect(reasonOf(comment(document, "a", "1", "ü".repeat(kMaxText + 1), ada))).toContain("at most");
    expect(reasonOf(comment(document, "p", "1", "x", ada))).toContain("states and barriers");
    expect(reasonOf(comment(document, "gone", "1", "x", ada))).toContain("not there");
    const many = (count: number, about: (i: number) => string) => applied(document, Array.from({ length: count }, (_, i) => operationsOf(comment(document, about(i), `c${i}`, "x", ada))).flat()).tree;
    const full = many(kMaxOnElement, () => "a");
    expect(reasonOf(comment(full, "a", "new", "x", ada))).toContain("no more");
    expect(reasonOf(answer(full, "c0", "new", "x", ada))).toContain("no more");
    expect(reasonOf(comment(full, "b", "new", "x", ada))).toBeUndefined();
    expect(reasonOf(comment(many(kMaxInDocument, (i) => ["a", "b", "c", "d", "r"][i % 5] ?? ""), "b", "new", "x", ada))).toContain("document");
  });
  it("can all be deleted with one message", () => {
    const ids = Array.from({ length: kMaxInDocument }, (_, i) => `12345678-${String(i).padStart(4, "0")}`);
    const full = applied(document, ids.flatMap((id) => [...operationsOf(comment(document, "c", id, "x", ada))])).tree;
    const resolved = applied(full, ids.flatMap((id) => [...operationsOf(resolve(full, id, ada))])).tree;
    expect(JSON.stringify(operationsOf(remove(resolved, ["c"]))).length).toBeLessThan(kMaxMessageBytes - 1000);
  });
  it("that are none by their shape are left alone", () => {
    const odd = treeOf({ rcm: 1, root: { state: "Root", meta: { id: "r" } }, meta: { "comment:1": "text", "comment:2": { about: "r", text: 7 }, "resolved:3": {} } });
    expect(commentsOf(odd).threads).toEqual([]);
    expect(commentsOf(treeOf({ rcm: 1, root: { state: "Root", meta: { id: "r" } }, meta: "a text" })).threads).toEqual([]);
  });
  it("are counted at their states, and where those are drawn closed", () => {
    const full = after(begun, (tree) => comment(tree, "d", "3", "Slow", ada), (tree) => comment(tree, "a", "4", "And?", ada), (tree) => resolve(tree, "1", bob));
    const marks = commentMarks(full, buildTree(editedState(full, "r")));
    expect(Object.fromEntries(marks.own)).toEqual({ "Root/A": 1, "Root/C/D": 1 });
    expect(Object.fromEntries(marks.inside)).toEqual({ Root: 2, "Root/C": 1 });
  });
  it("are no difference for a run", () => {
    const found = difference(document, begun);
    expect(differenceRows(document, begun, found)).toEqual([]);
    const titled = applied(begun, [{ op: "set", id: "", field: "meta", key: "title", value: "other" }]).tree;
    expect(differenceRows(document, titled, difference(document, titled))).toHaveLength(1);
  });
});

it("times are told as one reads them", () => {
  const now = Date.parse("2026-11-26T01:00:00Z");
  expect(timeText(Date.parse("2026-11-26T00:59:30Z"), now)).toBe("just now");
  expect(timeText(Date.parse("2026-11-26T00:50:00Z"), now)).toBe("10 min ago");
  expect(timeText(Date.parse("2025-01-02T00:50:00Z"), now)).toContain("2025");
  expect(timeText(Date.parse("soon"), now)).toBe("");
});
