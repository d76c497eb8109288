// Proposed changes of documents: what a page knows of them, what the address shows, and what is said.
import { describe, expect, it } from "vitest";
import type { Proposal } from "../../generated/messages";
import { readTree, type Tree } from "../../shared/edit/tree";
import { outlineOf } from "../../shared/proposals/outline";
import { applyProposals, firstShown, noProposals, readShown, shownText, type KnownProposals } from "../../shared/proposals/proposals";
import { outdatedText, proposerText, statusText, subjectText } from "../../shared/proposals/texts";
import { readStreamMessage } from "../../shared/messages/stream";
import { personText } from "../../shared/versions/texts";
import { readJson } from "../files";

const proposal = (id: string, more: Partial<Proposal> = {}): Proposal => ({ id, document: "task", base_revision: 3, author: "agent", note: "why", created: 1000, status: "open", ...more });
const told = (known: KnownProposals, whole: boolean, ...proposals: readonly Proposal[]) => applyProposals(known, { type: "told", proposals, whole });
const ids = ({ undecided }: KnownProposals) => undecided.map(({ id, status }) => `${id} ${status}`);

describe("the proposals that a page knows", () => {
  it("are those that nobody has decided about, the oldest first", () => {
    const known = told(noProposals, true, proposal("9"), proposal("10"));
    expect(ids(known)).toEqual(["9 open", "10 open"]);
    expect(ids(told(known, false, proposal("8"), proposal("9", { status: "outdated" })))).toEqual(["8 open", "9 outdated", "10 open"]);
    expect(ids(told(known, false, proposal("9", { status: "accepted" })))).toEqual(["10 open"]);
  });
  it("begin anew with a snapshot", () => {
    expect(ids(told(told(noProposals, true, proposal("9")), true, proposal("11")))).toEqual(["11 open"]);
  });
  it("come as messages of the stream", () => {
    const { channel, update } = readStreamMessage(readJson(new URL("../../../api/examples/stream_message.proposals.json", import.meta.url)));
    expect([channel, update.type === "proposals" && [update.whole, update.proposals.map(({ document }) => document)]]).toEqual(["proposals", [false, ["greet"]]]);
  });
});

describe("what is shown of them", () => {
  it("is in the address", () => {
    for (const shown of [undefined, { id: undefined }, { id: "17" }]) expect(readShown(shownText(shown))).toEqual(shown);
    expect([readShown("all"), readShown("1x"), readShown("")]).toEqual([undefined, undefined, undefined]);
  });
  it("stays the same object while nothing else is shown", () => {
    const known = applyProposals(noProposals, { type: "show", shown: { id: "7" } });
    expect(applyProposals(known, { type: "show", shown: { id: "7" } })).toBe(known);
    expect(applyProposals(known, { type: "show", shown: undefined }).shown).toBeUndefined();
    expect(applyProposals(known, { type: "show", shown: { id: undefined } }).shown).toEqual({ id: undefined });
  });
  it("is the only one at once", () => {
    expect([firstShown([proposal("7")]), firstShown([proposal("7"), proposal("8")])]).toEqual([{ id: "7" }, { id: undefined }]);
  });
});

describe("proposals in words", () => {
  it("say what they are about, and by whom", () => {
    expect([subjectText(proposal("1")), subjectText(proposal("1", { base_revision: null }))]).toEqual(["task, revision 3", "task, a new document"]);
    expect([proposerText(proposal("1", { author: "Ada~3f" })), proposerText(proposal("1", { author: "" }))]).toEqual(["Ada", "somebody"]);
  });
  it.each([
    ["accepted by Bob, as revision 4", { status: "accepted", decided_by: "Bob~1", revision: 4 }],
    ["declined by Bob: too fast", { status: "declined", decided_by: "Bob", reason: "too fast" }],
    ["declined by Bob", { status: "declined", decided_by: "Bob" }],
    ["withdrawn by agent", { status: "withdrawn", decided_by: "agent" }],
    ["outdated", { status: "outdated" }],
  ] as const)("say that one is %s", (text, more) => {
    expect(statusText(proposal("1", more))).toBe(text);
  });
  it("say what to do with one that is outdated", () => {
    expect(outdatedText(proposal("1"))).toMatch(/^task has changed since revision 3: .*agent proposes it anew/);
    expect(outdatedText(proposal("1", { base_revision: null }))).toMatch(/^There is a document task by now/);
  });
  it("name who has proposed a revision, and who has accepted it", () => {
    expect(personText({ revision: 4, author: "Bob~1", time: 0, message: "", origin: { kind: "proposal", author: "agent", proposal: "7" }, errors: 0 })).toBe("Bob, proposed by agent");
  });
});

describe("what a proposal changes", () => {
  const tree = (...states: readonly string[]) =>
    readTree({ rcm: 1, root: { state: "Root", meta: { id: "r" }, children: states.map((state) => ({ state, meta: { id: state } })) } }) as Tree;
  const rows = (before: Tree | undefined, after: Tree) => outlineOf(before, after).rows.map(({ kind, name }) => `${kind} ${name}`);
  it("is how it differs from its revision", () => {
    expect(rows(tree("A", "B"), tree("A", "C"))).toEqual(["added state Root/C", "removed state Root/B"]);
  });
  it("is, of a new document, the states that it has", () => {
    expect(rows(undefined, tree("A"))).toEqual(["added state Root", "added state Root/A"]);
  });
});
