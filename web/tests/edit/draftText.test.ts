import { describe, expect, it } from "vitest";
import { applyDraftEvent, draftsOf, isUnsent, keyOfPlace, noDrafts, readDrafts, theirText, writeDrafts, type DraftEvent, type DraftText, type Drafts } from "../../shared/edit/draftText";

const place = { document: "task", id: "a", field: "entry" };
const after = (...events: readonly DraftEvent[]): Drafts => events.reduce(applyDraftEvent, noDrafts);
const theirs = (drafts: Drafts, now: string | undefined) => {
  const draft = of(drafts);
  return draft && theirText(draft, now);
};
const of = (drafts: Drafts): DraftText | undefined => drafts.get(keyOfPlace(place));
const typed = (text: string, now = "pass"): DraftEvent => ({ type: "typed", place, text, now });

describe("the draft of a text", () => {
  it("begins with the first change, and ends when it is what the document has", () => {
    expect(of(after(typed("pas")))).toEqual({ ...place, text: "pas", base: "pass" });
    expect(of(after(typed("pas"), typed("pass")))).toBeUndefined();
  });
  it("is given up by its author alone", () => {
    expect(of(after(typed("x"), { type: "given_up", place }))).toBeUndefined();
  });
  it("is over when the document has it", () => {
    const sent = after(typed("x"), { type: "sent", place });
    expect(of(sent)).toMatchObject({ text: "x", sent: "x" });
    expect(of(applyDraftEvent(sent, { type: "accepted", place }))).toBeUndefined();
  });
  it("stays, with the reason, when it is refused, until it is changed", () => {
    const refused = after(typed("x"), { type: "sent", place }, { type: "refused", place, reason: "no" });
    expect(of(refused)).toEqual({ ...place, text: "x", base: "pass", reason: "no" });
    expect(of(applyDraftEvent(refused, typed("xy")))).toEqual({ ...place, text: "xy", base: "pass" });
  });
  it("goes on from what was sent, if more is written meanwhile", () => {
    const more = after(typed("x"), { type: "sent", place }, typed("xy", "x"));
    const draft = of(more);
    if (draft === undefined) throw new Error("no draft");
    expect([isUnsent(draft), theirText(draft, "x")]).toEqual([true, undefined]);
    expect(of(applyDraftEvent(more, { type: "accepted", place }))).toEqual({ ...place, text: "xy", base: "x" });
  });
  it("stays, with the reason, when it means nothing, though a text before it is accepted meanwhile", () => {
    const unreadable = after(typed("x"), { type: "sent", place }, typed("(", "x"), { type: "not_sent", place, reason: "no" });
    expect(of(unreadable)).toEqual({ ...place, text: "(", base: "pass", sent: "x", reason: "no" });
    expect(of(applyDraftEvent(unreadable, { type: "accepted", place }))).toEqual({ ...place, text: "(", base: "x", reason: "no" });
  });
  it("is overtaken by nobody while it is not known what the document has", () => {
    expect(theirs(after(typed("x")), undefined)).toBeUndefined();
  });
  it("knows what somebody else has written meanwhile, until its author keeps it", () => {
    const drafts = after(typed("mine"));
    expect(theirs(drafts, "theirs")).toBe("theirs");
    expect(theirs(drafts, "mine")).toBeUndefined();
    expect(theirs(applyDraftEvent(drafts, { type: "kept", place, now: "theirs" }), "theirs")).toBeUndefined();
  });
});

describe("kept drafts", () => {
  it("come back as they were, but not as sent", () => {
    const drafts = after(typed("x"), { type: "sent", place });
    expect(draftsOf(readDrafts(writeDrafts(drafts)), "task")).toEqual([{ ...place, text: "x", base: "pass" }]);
    expect(draftsOf(drafts, "other")).toEqual([]);
  });
  it.each(["", "nonsense", "{}", "[1, {}]"])("are none in %j", (text) => expect(readDrafts(text).size).toBe(0));
});
