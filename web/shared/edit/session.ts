// The session of a page that edits a document with others: the document that the server has confirmed, and the edits that the page has made
// and the server has not answered yet, which are shown at once. A state machine: what happens goes in, the next session and what is to be
// done come out. It has no socket and no clock.
import type { AcceptedEdit, CompoundEdit, DocumentSnapshot, EditRefusal, ServerError, StreamRequest } from "../../generated/messages";
import { apply, applyFitting, type Operation } from "./apply";
import { plain, writeExact, type Exact } from "./exact";
import { Refusal } from "./refusal";
import { readTree, type Tree } from "./tree";

/** What a user does. Only operations are shown before the server has answered: the server makes the others on its own document. */
export type Change =
  | { readonly operations: readonly Exact<Operation>[] }
  | { readonly compound: Exact<CompoundEdit> }
  | { readonly undo: true }
  | { readonly redo: true };

/** How many edits may wait for the server. */
export const kMaxPending = 64;
/** Of a message to the server [byte]. */
export const kMaxMessageBytes = 64 * 1024;

/** An edit that the server has not answered. */
export interface PendingEdit {
  /** The token by which the server knows it when it is sent again. */
  readonly request: string;
  /** The revision that its author has seen. */
  readonly revision: number;
  readonly change: Change;
  /** The operations as JavaScript has them; none of other changes. */
  readonly operations: readonly Operation[];
  /** How often it was sent over this connection and not answered. */
  readonly copies: number;
  /** The revision that it has made, if that is known before its operations are. */
  readonly accepted?: number;
}

export interface EditSession {
  readonly document: string;
  readonly author: string;
  readonly connected: boolean;
  /** Deltas did not fit to what is here: a snapshot is on its way. */
  readonly stale: boolean;
  /** As the server has it; nothing before the first snapshot, and of a document that cannot be edited (`unreadable`). */
  readonly confirmed: { readonly tree: Tree; readonly revision: number } | undefined;
  /** Why there is nothing to edit: the document is not on the server, or is none that can be read here. */
  readonly unreadable: ServerError | undefined;
  /** The confirmed document with the pending edits, as far as they can be applied to it. */
  readonly view: Tree | undefined;
  /** Violations of the confirmed document. */
  readonly errors: readonly ServerError[];
  /** How many edits the author can take back and give again; nothing before the author's first edit is accepted. */
  readonly depths: { readonly undo: number; readonly redo: number } | undefined;
  readonly pending: readonly PendingEdit[];
}

export type SessionInput =
  /** `request`: a new token, 1 to 64 of A-Z a-z 0-9 _ -. */
  | { readonly type: "edit"; readonly request: string; readonly change: Change }
  | { readonly type: "snapshot"; readonly snapshot: DocumentSnapshot }
  /** Of the channel. */
  | { readonly type: "accepted"; readonly edit: AcceptedEdit }
  /** To this page only; the channel says the same, before or after, if it is subscribed. */
  | { readonly type: "acknowledged"; readonly edit: AcceptedEdit }
  | { readonly type: "refused"; readonly refusal: EditRefusal }
  /** There is no channel of this document, or not any more. It is asked for again when the connection returns. */
  | { readonly type: "ended"; readonly channel: string; readonly errors: readonly ServerError[] }
  | { readonly type: "connection"; readonly connected: boolean }
  /** The author has another name: taken up only as long as there is nothing to undo, as the server keeps undo by it. */
  | { readonly type: "author"; readonly author: string }
  /** A while after an output with `retry`. */
  | { readonly type: "retry" };

/** For the user: an edit is not in the document and will not be. */
export interface Notice {
  /** Its token. */
  readonly request: string;
  readonly change: Change;
  readonly errors: readonly ServerError[];
  /** The edit that is the reason, if there is one. */
  readonly revision?: number;
  readonly author?: string;
}

export interface SessionOutput {
  readonly session: EditSession;
  /** To send in this order. What cannot be sent need not be kept: it is sent again after a reconnect. */
  readonly messages: readonly Exact<StreamRequest>[];
  readonly notices: readonly Notice[];
  /** The server had no room for an edit: `retry` is to come in a while. */
  readonly retry?: true;
}

export function newSession(document: string, author: string): EditSession {
  return { document, author, connected: false, stale: false, confirmed: undefined, unreadable: undefined, view: undefined, errors: [], depths: undefined, pending: [] };
}

export const channelOf = (document: string): string => `document/${document}`;

function messageOf({ document, author }: EditSession, { request, revision, change }: PendingEdit): Exact<StreamRequest> {
  return { type: "edit", document, request, revision, author, ...change };
}

/** The session with its view. */
function shown(session: Omit<EditSession, "view">): EditSession {
  const { confirmed, pending } = session;
  return { ...session, view: confirmed && applyFitting(confirmed.tree, pending) };
}

const quiet = (session: EditSession): SessionOutput => ({ session, messages: [], notices: [] });

/** What the server has to be told anew: all that it has not answered, which it knows by its tokens if it has accepted it. */
function resend(session: EditSession): SessionOutput {
  const { connected, stale, document } = session;
  if (!connected) return quiet(session);
  const isSent = ({ accepted }: PendingEdit) => accepted === undefined;
  const messages = session.pending.filter(isSent).map((edit) => messageOf(session, edit));
  const pending = session.pending.map((edit) => (isSent(edit) ? { ...edit, copies: edit.copies + 1 } : edit));
  return { session: { ...session, pending }, messages: stale ? [snapshotRequest(document), ...messages] : messages, notices: [] };
}

/** Without the number of the last message: the answer is a snapshot. */
const snapshotRequest = (document: string): StreamRequest => ({ type: "subscribe", channel: channelOf(document) });

function edit(session: EditSession, request: string, change: Change): SessionOutput {
  const refused = (code: string, message: string, path = ""): SessionOutput => ({ session, messages: [], notices: [{ request, change, errors: [{ path, code, message }] }] });
  const { confirmed, view, pending, connected } = session;
  if (confirmed === undefined || view === undefined) return refused("unavailable", "the document is not here");
  if (pending.length >= kMaxPending) return refused("too_large", `${kMaxPending} edits wait for the server`);
  const operations = "operations" in change ? plain<readonly Operation[]>(change.operations) : [];
  const result = apply(view, { operations });
  if (result instanceof Refusal) return refused(result.code, result.message, result.path);
  const added: PendingEdit = { request, revision: confirmed.revision, change, operations, copies: connected ? 1 : 0 };
  const message = messageOf(session, added);
  if (new TextEncoder().encode(writeExact(message)).length > kMaxMessageBytes) return refused("too_large", `a message has at most ${kMaxMessageBytes} bytes`);
  return { session: { ...session, view: result.tree, pending: [...pending, added] }, messages: connected ? [message] : [], notices: [] };
}

/** Edits that are in the document of `revision` do not wait any more. */
const without = (pending: readonly PendingEdit[], revision: number): readonly PendingEdit[] => pending.filter(({ accepted }) => accepted === undefined || accepted > revision);

function snapshot(session: EditSession, { revision, json, errors }: DocumentSnapshot): SessionOutput {
  const tree = readTree(json);
  if (tree instanceof Refusal) return quiet(shown({ ...session, confirmed: undefined, unreadable: tree, stale: false, errors }));
  const pending = without(session.pending, revision);
  // Messages about these edits may have been dropped for the snapshot.
  return resend(shown({ ...session, confirmed: { tree, revision }, unreadable: undefined, stale: false, errors, pending }));
}

/** Without the document nothing is shown. Pending edits wait for their own answers. */
function ended(session: EditSession, [reason]: readonly ServerError[]): SessionOutput {
  return quiet(shown({ ...session, confirmed: undefined, unreadable: reason, stale: false, errors: [] }));
}

/** The pending edit `request` is in the document of `revision`. */
function acknowledge(session: EditSession, request: string | undefined, revision: number): EditSession {
  if (!session.pending.some((each) => each.request === request)) return session;
  const pending = session.pending.map((each) => (each.request === request ? { ...each, accepted: revision } : each));
  return shown({ ...session, pending: session.confirmed === undefined ? pending : without(pending, session.confirmed.revision) });
}

function accepted(session: EditSession, edit: AcceptedEdit): SessionOutput {
  const { confirmed, stale, document } = session;
  const { revision, operations, errors, author, undo, redo } = edit;
  const known = acknowledge(session, edit.request, revision);
  if (confirmed === undefined || stale || revision <= confirmed.revision) return quiet(known);
  const result = apply(confirmed.tree, { operations });
  if (revision !== confirmed.revision + 1 || result instanceof Refusal)
    return { session: { ...known, stale: true }, messages: session.connected ? [snapshotRequest(document)] : [], notices: [] };
  const depths = author === session.author ? { undo, redo } : session.depths;
  return quiet(shown({ ...known, confirmed: { tree: result.tree, revision }, errors, depths, pending: without(known.pending, revision) }));
}

/** The server has not looked at the edit: it says nothing about it. */
const isBusy = (errors: readonly ServerError[]): boolean => errors.some(({ code }) => code === "unavailable");

function refused(session: EditSession, { request, errors, revision, author }: EditRefusal): SessionOutput {
  const found = session.pending.find((each) => each.request === request && each.accepted === undefined);
  if (found === undefined) return quiet(session);
  // Another copy is under way, and may still be accepted: the last answer counts.
  if (found.copies > 1 || isBusy(errors)) {
    const pending = session.pending.map((each) => (each === found ? { ...each, copies: each.copies - 1 } : each));
    return { ...quiet({ ...session, pending }), ...(isBusy(errors) && { retry: true }) };
  }
  const notice: Notice = { request, change: found.change, errors, ...(revision !== undefined && { revision }), ...(author !== undefined && { author }) };
  return { session: shown({ ...session, pending: session.pending.filter((each) => each !== found) }), messages: [], notices: [notice] };
}

/** Sends what no copy is under way of. */
function retry(session: EditSession): SessionOutput {
  if (!session.connected) return quiet(session);
  const isIdle = ({ accepted, copies }: PendingEdit) => accepted === undefined && copies <= 0;
  const messages = session.pending.filter(isIdle).map((edit) => messageOf(session, edit));
  const pending = session.pending.map((edit) => (isIdle(edit) ? { ...edit, copies: 1 } : edit));
  return { session: { ...session, pending }, messages, notices: [] };
}

export function step(session: EditSession, input: SessionInput): SessionOutput {
  switch (input.type) {
    case "edit":
      return edit(session, input.request, input.change);
    case "snapshot":
      return snapshot(session, input.snapshot);
    case "accepted":
      return accepted(session, input.edit);
    case "acknowledged":
      return quiet(acknowledge(session, input.edit.request, input.edit.revision));
    case "refused":
      return refused(session, input.refusal);
    case "ended":
      return ended(session, input.errors);
    case "connection":
      return resend({ ...session, connected: input.connected, pending: session.pending.map((edit) => ({ ...edit, copies: 0 })) });
    case "author":
      return session.depths === undefined && session.pending.length === 0 ? quiet({ ...session, author: input.author }) : quiet(session);
    case "retry":
      return retry(session);
  }
}
