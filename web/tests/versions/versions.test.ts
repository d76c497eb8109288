// The history of a document: which revisions are one row, what a page has loaded of them, and what it says.
import { describe, expect, it } from "vitest";
import type { DocumentRevision, Revisions } from "../../generated/messages";
import { groupOf, groupRevisions, kSitting } from "../../shared/versions/groups";
import { applyHistory, noHistory, type History } from "../../shared/versions/history";
import { rangeText, readRange } from "../../shared/versions/range";
import { draftText, groupText, numbersText, originText, personText, rangeTitle, whenText } from "../../shared/versions/texts";

const kMinute = 60_000;
const edit = (revision: number, minute: number, more: Partial<DocumentRevision> = {}): DocumentRevision => ({
  revision, author: "Ada~x1", time: minute * kMinute, message: "", origin: { kind: "edit" }, errors: 0, ...more,
});
const numbers = (revisions: readonly DocumentRevision[]) => groupRevisions(revisions).map((group) => group.revisions.map(({ revision }) => revision));

describe("rows of the history", () => {
  it("have the edits, undos and redos of one person in one sitting", () => {
    expect(numbers([edit(4, 4), edit(3, 3, { origin: { kind: "undo", revision: 2 } }), edit(2, 2), edit(1, 1, { origin: { kind: "put" } })])).toEqual([[4, 3, 2], [1]]);
  });
  it.each([
    ["another person", { author: "Bob~x1" }],
    ["another page of the same person", { author: "Ada~y2" }],
    ["a whole text", { origin: { kind: "put" } as const }],
    ["a message", { message: "better grip" }],
  ])("end with %s", (_, more) => {
    expect(numbers([edit(3, 3), edit(2, 2, more), edit(1, 1)])).toEqual([[3], [2], [1]]);
  });
  it("end after a while without an edit", () => {
    const at = (time: number) => numbers([{ ...edit(2, 0), time }, { ...edit(1, 0), time: 0 }]).length;
    expect([at(kSitting), at(kSitting + 1)]).toEqual([1, 2]);
  });
  it("say what they have", () => {
    const [group] = groupRevisions([edit(9, 3, { origin: { kind: "undo", revision: 8 } }), edit(8, 2), edit(7, 1)]);
    expect(group && [numbersText(group), groupText(group)]).toEqual(["7 to 9", "3 edits, 1 of them undo"]);
    expect(groupOf(groupRevisions([edit(9, 3), edit(8, 2)]), 8)?.last.revision).toBe(9);
    expect(groupOf(groupRevisions([edit(9, 3)]), 8)).toBeUndefined();
  });
});

describe("the revisions that are loaded", () => {
  const page = (revisions: readonly number[], next?: number, name = "task"): Revisions => ({ name, revisions: revisions.map((n) => edit(n, n)), ...(next !== undefined && { next }) });
  const open = applyHistory(noHistory, { type: "document", document: "task" });
  const load = (history: History, ...pages: readonly Revisions[]) => pages.reduce((now, each) => applyHistory(now, { type: "loaded", page: each }), history);
  const seen = ({ revisions, next }: History) => [revisions.map(({ revision }) => revision), next];

  it("begin with the newest, and go on with older ones", () => {
    expect(seen(load(open, page([5, 4], 4), page([3, 2], 2)))).toEqual([[5, 4, 3, 2], 2]);
  });
  it("keep the older ones when newer ones are made", () => {
    expect(seen(load(open, page([5, 4], 4), page([3, 2], 2), page([6, 5], 5)))).toEqual([[6, 5, 4, 3, 2], 2]);
  });
  it("have no gaps: what does not follow is dropped", () => {
    expect(seen(load(open, page([3, 2], 2), page([9, 8], 8)))).toEqual([[9, 8], 8]);
    expect(seen(load(open, page([9, 8], 8), page([3, 2], 2)))).toEqual([[3, 2], 2]);
  });
  it("are those of the document that is open", () => {
    expect(seen(load(open, page([5], undefined, "other")))).toEqual([[], undefined]);
    const other = applyHistory(load(open, page([5])), { type: "document", document: "other" });
    expect(seen(other)).toEqual([[], undefined]);
  });
  it("are shown when something is compared, and nothing is when they are closed", () => {
    const compared = applyHistory(open, { type: "compare", range: { from: 2, to: undefined } });
    expect(compared.shown).toBe(true);
    expect(applyHistory(compared, { type: "show", shown: false }).range).toBeUndefined();
  });
  it("say why they could not be loaded, until they are", () => {
    const failed = applyHistory(open, { type: "failed", document: "task", reason: "storage" });
    expect([failed.reason, load(failed, page([1])).reason]).toEqual(["storage", undefined]);
  });
});

describe("what is compared, in the address", () => {
  it.each(["14..", "13..14", "1..999999999"])("is read as it is written: %s", (text) => {
    const range = readRange(text);
    expect(range && rangeText(range)).toBe(text);
  });
  it.each(["", "list", "14", "0..", "..14", "14..13", "14..14", "-1..2", "1..2..3", "1e3..", "1..9999999999"])("is nothing otherwise: %j", (text) => {
    expect(readRange(text)).toBeUndefined();
  });
  it("has a title", () => {
    expect([rangeTitle({ from: 3, to: undefined }), rangeTitle({ from: 3, to: 4 }), rangeTitle({ from: 3, to: 9 })]).toEqual([
      "Changed since revision 3", "Changed by revision 4", "Changed by revisions 4 to 9",
    ]);
  });
});

describe("texts of a revision", () => {
  it("say where it comes from", () => {
    const text = (origin: DocumentRevision["origin"]) => originText(edit(1, 1, { origin }));
    expect(text({ kind: "restore", revision: 3 })).toBe("revision 3 restored");
    expect(text({ kind: "branch", document: "pick", revision: 2 })).toBe("branched from pick, revision 2");
  });
  it("name the person, not the page", () => {
    expect([personText(edit(1, 1)), personText(edit(1, 1, { author: "" }))]).toEqual(["Ada", "somebody"]);
  });
  it("say when it was stored, if that is known", () => {
    expect([whenText(edit(1, 5), 6 * kMinute), whenText(edit(1, 0), 6 * kMinute)]).toEqual(["1 min ago", "at an unknown time"]);
  });
  it("say that it is a draft", () => {
    expect([0, 1, 201].map((errors) => draftText(edit(1, 1, { errors })))).toEqual([undefined, "draft, 1 error", "draft, more than 200 errors"]);
  });
});
