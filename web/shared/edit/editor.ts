// The adapter between the session of a document and the stream: passes messages on, and gives each edit its token.
import { newId } from "../newId";
import type { Connection, Stream } from "../stream";
import type { StreamUpdate } from "../messages/stream";
import { channelOf, newSession, step, type Change, type EditSession, type Notice, type SessionInput } from "./session";

export interface EditorHandlers {
  readonly onSession: (session: EditSession) => void;
  readonly onNotice: (notice: Notice) => void;
}

export interface Editor {
  readonly session: () => EditSession;
  readonly edit: (change: Change) => void;
  /** Every update of the stream; those that are not of this document are ignored. */
  readonly receive: (update: StreamUpdate) => void;
  readonly connection: (connection: Connection) => void;
  /** As SessionInput has it. */
  readonly rename: (author: string) => void;
  readonly close: () => void;
}

/** How long an edit waits that the server had no room for [ms]. */
const kRetry = 500;

function inputOf(update: StreamUpdate): SessionInput | undefined {
  switch (update.type) {
    case "document":
      return { type: "snapshot", snapshot: update.snapshot };
    case "document_edited":
      return { type: "accepted", edit: update.edit };
    case "edit_accepted":
      return { type: "acknowledged", edit: update.edit };
    case "edit_refused":
      return { type: "refused", refusal: update.refusal };
    case "refused":
      return { type: "ended", channel: update.channel, errors: update.errors };
    default:
      return undefined;
  }
}

/** The channel of the document that an input is about; nothing if it is about none. */
function channelIn(input: SessionInput): string | undefined {
  switch (input.type) {
    case "snapshot":
      return channelOf(input.snapshot.document);
    case "refused":
      return channelOf(input.refusal.document);
    case "ended":
      return input.channel;
    case "accepted":
    case "acknowledged":
      return channelOf(input.edit.document);
    default:
      return undefined;
  }
}

/** Follows and edits `document` as `author`. `connection`: of the stream, now. `newToken`: 1 to 64 of A-Z a-z 0-9 _ -, each time others. */
export function openEditor(
  stream: Pick<Stream, "send" | "subscribe" | "unsubscribe">,
  connection: Connection,
  document: string,
  author: string,
  handlers: EditorHandlers,
  newToken: () => string = newId,
): Editor {
  let session: EditSession = { ...newSession(document, author), connected: connection === "open" };
  let retrying: ReturnType<typeof setTimeout> | undefined;
  const put = (input: SessionInput) => {
    const { session: next, messages, notices, retry } = step(session, input);
    const isNew = next !== session;
    session = next;
    for (const message of messages) {
      if (message.type === "subscribe") stream.subscribe(message.channel);
      else if (message.type === "edit") stream.send(message);
    }
    if (retry)
      retrying ??= setTimeout(() => {
        retrying = undefined;
        put({ type: "retry" });
      }, kRetry);
    if (isNew) handlers.onSession(session);
    notices.forEach(handlers.onNotice);
  };
  stream.subscribe(channelOf(document));
  return {
    session: () => session,
    edit: (change) => put({ type: "edit", request: newToken(), change }),
    receive: (update) => {
      const input = inputOf(update);
      if (input !== undefined && channelIn(input) === channelOf(document)) put(input);
    },
    connection: (now) => put({ type: "connection", connected: now === "open" }),
    rename: (name) => put({ type: "author", author: name }),
    close: () => {
      clearTimeout(retrying);
      stream.unsubscribe(channelOf(document));
    },
  };
}
