import { describe, expect, it } from "vitest";
import { readExact, writeExact } from "../../shared/edit/exact";
import type { AcceptedEdit } from "../../generated/messages";
import type { Operation } from "../../shared/edit/apply";
import { kMaxMessageBytes, kMaxPending, newSession, step, type EditSession, type SessionInput, type SessionOutput } from "../../shared/edit/session";
import { elementOf } from "../../shared/edit/tree";
import type { JsonObject } from "../../shared/json";
import { documentText, vector } from "./documents";

const small = (vector("apply.remove.json") as { readonly document: JsonObject }).document;

const setDoc = (id: string, value: string): Operation => ({ op: "set", id, field: "doc", value });
const edit = (request: string, ...operations: readonly Operation[]): SessionInput => ({ type: "edit", request, change: { operations } });
const snapshot = (revision: number, json = small): SessionInput => ({ type: "snapshot", snapshot: { document: "small", revision, json, errors: [] } });
const accepted = (revision: number, author: string, operations: readonly Operation[], request?: string): AcceptedEdit => ({
  document: "small", revision, author, message: "", time: 0, kind: "change", operations, errors: [], undo: 1, redo: 0, ...(request !== undefined && { request }),
});
const delta = (...of: Parameters<typeof accepted>): SessionInput => ({ type: "accepted", edit: accepted(...of) });
const refused = (request: string): SessionInput => ({
  type: "refused", refusal: { document: "small", request, errors: [{ path: "operations/0/id", code: "conflict", message: "was removed" }], revision: 6, author: "bob" },
});
const connection = (connected: boolean): SessionInput => ({ type: "connection", connected });

function run(session: EditSession, ...inputs: readonly SessionInput[]): SessionOutput {
  return inputs.reduce<SessionOutput>(
    (before, input) => {
      const { session: next, messages, notices } = step(before.session, input);
      return { session: next, messages: [...before.messages, ...messages], notices: [...before.notices, ...notices] };
    },
    { session, messages: [], notices: [] },
  );
}

const open = run(newSession("small", "ann"), connection(true), snapshot(5)).session;
const docOf = ({ view }: EditSession, id: string) => view && elementOf(view, id).fields["doc"];

describe("a session", () => {
  it("shows an edit at once, and sends it with its token and the revision that its author has seen", () => {
    const { session, messages, notices } = run(open, edit("t1", setDoc("a", "new")));
    expect(docOf(session, "a")).toBe("new");
    expect(messages).toEqual([{ type: "edit", document: "small", request: "t1", revision: 5, author: "ann", operations: [setDoc("a", "new")] }]);
    expect(notices).toEqual([]);
    expect(session.confirmed).toBe(open.confirmed);
  });
  it("takes the delta with its token as the acknowledgement", () => {
    const { session, notices } = run(open, edit("t1", setDoc("a", "new")), delta(6, "ann", [setDoc("a", "new")], "t1"));
    expect(session).toMatchObject({ pending: [], confirmed: { revision: 6 }, depths: { undo: 1, redo: 0 } });
    expect(docOf(session, "a")).toBe("new");
    expect(notices).toEqual([]);
  });
  it("applies its pending edits anew on those of others", () => {
    const { session } = run(open, edit("t1", setDoc("a", "ann")), delta(6, "bob", [setDoc("a", "bob"), setDoc("b", "bob")]));
    expect([docOf(session, "a"), docOf(session, "b")]).toEqual(["ann", "bob"]);
    expect(session.depths).toBeUndefined();
  });
  it("takes up another name of its author as long as there is nothing to undo: the server keeps undo by it", () => {
    const named: SessionInput = { type: "author", author: "ann lee" };
    expect(run(open, named).session.author).toBe("ann lee");
    expect(run(open, edit("t1", setDoc("a", "new")), named).session.author, "an edit is on its way").toBe("ann");
    expect(run(open, edit("t1", setDoc("a", "new")), delta(6, "ann", [setDoc("a", "new")], "t1"), named).session.author).toBe("ann");
  });
  it("keeps an edit that the server had no room for, and sends it again in a while", () => {
    const busy: SessionInput = { type: "refused", refusal: { document: "small", request: "t1", errors: [{ path: "request", code: "unavailable", message: "too many" }] } };
    const waiting = step(run(open, edit("t1", setDoc("a", "new"))).session, busy);
    expect(waiting).toMatchObject({ retry: true, messages: [], notices: [] });
    expect(docOf(waiting.session, "a")).toBe("new");
    const again = step(waiting.session, { type: "retry" });
    expect(again.messages).toMatchObject([{ request: "t1" }]);
    expect(step(again.session, { type: "retry" }).messages, "a copy is under way").toEqual([]);
    expect(run(again.session, refused("t1"))).toMatchObject({ session: { pending: [] }, notices: [{ request: "t1" }] });
    expect(run(waiting.session, connection(false), { type: "retry" }).messages).toEqual([]);
  });
  it("hides an edit that does not apply any more, until the server answers, and tells its author why it was refused, once", () => {
    const hidden = run(open, edit("t1", setDoc("b", "ann")), edit("t2", setDoc("a", "ann")), delta(6, "bob", [{ op: "remove", id: "b" }])).session;
    expect([hidden.view?.elements.has("b"), docOf(hidden, "a"), hidden.pending.length]).toEqual([false, "ann", 2]);
    const { session, notices } = run(hidden, refused("t1"), refused("t1"));
    expect(session.pending.map(({ request }) => request)).toEqual(["t2"]);
    expect(notices).toEqual([{ request: "t1", change: { operations: [setDoc("b", "ann")] }, errors: [{ path: "operations/0/id", code: "conflict", message: "was removed" }], revision: 6, author: "bob" }]);
  });
  it("refuses an edit that does not apply to what is shown, and sends nothing", () => {
    const { session, messages, notices } = run(open, edit("t1", setDoc("nobody", "x")));
    expect(session).toBe(open);
    expect(messages).toEqual([]);
    expect(notices).toMatchObject([{ errors: [{ code: "not_found", path: "operations/0/id" }] }]);
  });
  it("sends undo, redo and compound edits, and waits for what they do", () => {
    const changes = [{ undo: true }, { redo: true }, { compound: { kind: "duplicate", id: "a" } }] as const;
    for (const change of changes) {
      const { session, messages } = run(open, { type: "edit", request: "t", change });
      expect(messages).toEqual([{ type: "edit", document: "small", request: "t", revision: 5, author: "ann", ...change }]);
      expect(session.pending.length).toBe(1);
      expect(session.view).toEqual(open.view);
    }
  });
  it("ignores a delta that it has had", () => {
    const once = run(open, delta(6, "bob", [setDoc("a", "bob")])).session;
    expect(run(once, delta(6, "bob", [setDoc("a", "bob")])).session).toBe(once);
  });
  it("asks for a snapshot, once, if deltas are missing or do not fit", () => {
    for (const first of [delta(7, "bob", [setDoc("a", "bob")]), delta(6, "bob", [setDoc("nobody", "bob")])]) {
      const { session, messages } = run(open, first, delta(8, "bob", [setDoc("a", "bob")]));
      expect(messages).toEqual([{ type: "subscribe", channel: "document/small" }]);
      expect(run(session, connection(false), connection(true)).messages).toEqual(messages);
      expect(run(session, snapshot(8)).session).toMatchObject({ stale: false, confirmed: { revision: 8 } });
    }
  });
  it("sends again what was not answered when the connection returns", () => {
    const lost = run(open, edit("t1", setDoc("a", "1")), connection(false), edit("t2", setDoc("a", "2")));
    expect(lost.messages.map((message) => "request" in message && message.request)).toEqual(["t1"]);
    const back = run(lost.session, connection(true));
    expect(back.messages).toMatchObject([{ request: "t1", revision: 5 }, { request: "t2", revision: 5 }]);
  });
  it("drops an edit that is in a snapshot, once it is told so, before or after", () => {
    const waiting = run(open, edit("t1", { op: "remove", id: "b" })).session;
    const acknowledged: SessionInput = { type: "acknowledged", edit: accepted(6, "ann", [{ op: "remove", id: "b" }], "t1") };
    expect(run(waiting, snapshot(6), acknowledged).session.pending).toEqual([]);
    expect(run(waiting, acknowledged).session.pending.length).toBe(1);
    expect(run(waiting, acknowledged, connection(false), connection(true)).messages).toEqual([]);
    expect(run(waiting, acknowledged, snapshot(6)).session.pending).toEqual([]);
  });
  it("sends again what was not answered when a snapshot replaces deltas, which may have been the answer", () => {
    const waiting = run(open, edit("t1", setDoc("a", "1"))).session;
    expect(run(waiting, snapshot(9)).messages).toMatchObject([{ request: "t1" }]);
  });
  it("waits for all answers to an edit that it has sent twice, of which an acceptance counts", () => {
    const twice = run(open, edit("t1", setDoc("a", "1")), snapshot(6), refused("t1"));
    expect([twice.session.pending.length, twice.notices]).toEqual([1, []]);
    expect(run(twice.session, refused("t1"))).toMatchObject({ session: { pending: [] }, notices: [{ request: "t1" }] });
    expect(run(twice.session, delta(7, "ann", [setDoc("a", "1")], "t1"))).toMatchObject({ session: { pending: [] }, notices: [] });
    expect(run(twice.session, connection(false), connection(true), refused("t1")).notices).toMatchObject([{ request: "t1" }]);
  });
  it("accepts as many edits as may wait, and no more", () => {
    const inputs = Array.from({ length: kMaxPending }, (_, i) => edit(`t${i}`, setDoc("a", `${i}`)));
    const full = run(open, ...inputs);
    expect([full.notices, full.session.pending.length]).toEqual([[], kMaxPending]);
    const more = run(full.session, edit("more", setDoc("a", "more")));
    expect(more.notices).toMatchObject([{ errors: [{ code: "too_large" }] }]);
    expect(more.messages).toEqual([]);
    expect(more.session).toBe(full.session);
  });
  it("accepts a message of the size that the server takes, and no larger one", () => {
    const [empty] = run(open, edit("t", setDoc("a", "ü"))).messages;
    const room = kMaxMessageBytes - new TextEncoder().encode(writeExact(empty)).length;
    expect(run(open, edit("t", setDoc("a", `ü${"x".repeat(room)}`))).messages.length).toBe(1);
    expect(run(open, edit("t", setDoc("a", `ü${"x".repeat(room + 1)}`)))).toMatchObject({ messages: [], notices: [{ errors: [{ code: "too_large" }] }] });
  });
  it("sends a number as it was written", () => {
    const change = { operations: [{ op: "set", id: "p", field: "value", value: readExact("[2.0, 2]") }] } as const;
    const { session, messages } = run(open, { type: "edit", request: "t", change });
    expect(writeExact(messages[0])).toContain('"value":[2.0,2]');
    expect(session.view && elementOf(session.view, "p").fields["value"]).toEqual([2, 2]);
  });
  it("says why there is no document, keeps what waits for its answer, and shows the document when it is there", () => {
    const reason = { path: "document/small", code: "not_found", message: "there is no channel of this name" };
    const gone = run(open, edit("t1", setDoc("a", "new")), { type: "ended", channel: "document/small", errors: [reason] });
    expect(gone.session).toMatchObject({ confirmed: undefined, view: undefined, unreadable: reason, pending: [{ request: "t1" }] });
    expect(run(gone.session, refused("t1"))).toMatchObject({ session: { pending: [] }, notices: [{ request: "t1" }] });
    expect(run(gone.session, snapshot(7)).session).toMatchObject({ confirmed: { revision: 7 }, unreadable: undefined });
  });
  it("does not edit a document that it does not have or cannot read", () => {
    const unreadable = run(open, snapshot(6, { rcm: 1, root: { state: "R" } })).session;
    expect(unreadable).toMatchObject({ view: undefined, unreadable: { code: "missing" } });
    for (const session of [unreadable, newSession("small", "ann")]) expect(run(session, edit("t", setDoc("a", "x"))).notices).toMatchObject([{ errors: [{ code: "unavailable" }] }]);
    const readable = run(unreadable, snapshot(7)).session;
    expect(readable.unreadable).toBeUndefined();
    expect(readable.view && documentText(readable.view)).toBe(open.view && documentText(open.view));
  });
});
