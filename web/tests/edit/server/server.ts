// A simulated server of one document, and its connections: each delivers in order, late, and may break with what is under way.

import type { Operation } from "../../../shared/edit/apply";
import type { AcceptedEdit, StreamRequest } from "../../../generated/messages";
import { documentOf, type Tree } from "../../../shared/edit/tree";
import type { SessionInput } from "../../../shared/edit/session";
import type { JsonObject } from "../../../shared/json";
import { History } from "./history";
import type { LogEntry } from "./log";

export type EditMessage = Extract<StreamRequest, { readonly type: "edit" }>;

/** What a client is told: an input of its session, and the sequence number if it is of the channel. */
export interface Told {
  readonly input: SessionInput;
  readonly sequence?: number;
}

/** One connection of a client, from its opening on. */
export class Connection {
  readonly toServer: StreamRequest[] = [];
  readonly toClient: Told[] = [];
  isSubscribed = false;
  /** It was too slow: until the snapshot, messages of the channel are dropped. */
  needsSnapshot = false;
  /** It was too slow: the server has ended it. */
  isEnded = false;
}

/** How many messages to this client alone may be queued: nothing repeats one, so none is dropped unless the connection ends. */
const kPrivateMessages = 3;

export class SimulatedServer {
  readonly history: History;
  readonly connections = new Set<Connection>();
  private readonly accepted = new Map<string, AcceptedEdit>();
  private readonly deltas: AcceptedEdit[] = [];

  constructor(
    tree: Tree,
    private readonly document: string,
    /** How many deltas a client that reconnects can get. */
    private readonly keptDeltas: number,
  ) {
    this.history = new History(tree, 1);
  }

  /** The tokens of the accepted edits, in order. */
  get requests(): readonly (string | undefined)[] {
    return this.deltas.map(({ request }) => request);
  }

  /** Handles the oldest message of a connection, if there is one. */
  receive(connection: Connection): void {
    const message = connection.toServer.shift();
    if (message?.type === "subscribe") this.subscribe(connection, message.since);
    if (message?.type === "edit") this.edit(connection, message);
  }

  /** What was queued of the channel for a slow client is dropped; it gets a snapshot later. */
  overflow(connection: Connection): void {
    connection.toClient.splice(0, connection.toClient.length, ...connection.toClient.filter(({ sequence }) => sequence === undefined));
    connection.needsSnapshot = connection.isSubscribed;
  }

  catchUp(connection: Connection): void {
    if (connection.needsSnapshot) this.subscribe(connection, undefined);
  }

  /** Tells this client alone. */
  private tell(connection: Connection, input: SessionInput): void {
    const queued = connection.toClient.filter(({ sequence }) => sequence === undefined).length;
    if (queued >= kPrivateMessages) this.end(connection);
    else connection.toClient.push({ input });
  }

  /** What is under way is lost. */
  private end(connection: Connection): void {
    this.connections.delete(connection);
    connection.toClient.length = 0;
    connection.toServer.length = 0;
    connection.isEnded = true;
  }

  private subscribe(connection: Connection, since: number | undefined): void {
    connection.isSubscribed = true;
    connection.needsSnapshot = false;
    if (since !== undefined && since <= this.deltas.length && this.deltas.length - since <= this.keptDeltas) {
      this.deltas.slice(since).forEach((edit, i) => connection.toClient.push({ input: { type: "accepted", edit }, sequence: since + i + 1 }));
      return;
    }
    const json = documentOf(this.history.tree) as unknown as JsonObject;
    const snapshot = { document: this.document, revision: this.history.revision, json, errors: [] };
    connection.toClient.push({ input: { type: "snapshot", snapshot }, sequence: this.deltas.length });
  }

  private apply(author: string, message: EditMessage): ReturnType<History["apply"]> {
    if (message.undo === true) return this.history.undo(author);
    if (message.redo === true) return this.history.redo(author);
    return this.history.apply(author, message.revision ?? 0, { operations: message.operations ?? [] });
  }

  private edit(connection: Connection, message: EditMessage): void {
    const { request = "" } = message;
    const known = this.accepted.get(request);
    if (known !== undefined) {
      this.tell(connection, { type: "acknowledged", edit: known });
      return;
    }
    const author = message.author ?? "";
    const result = this.apply(author, message);
    if ("edit" in result) {
      this.publish(connection, request, result);
      return;
    }
    const { path, code, revision, author: other } = result;
    const errors = [{ path, code, message: "rejected" }];
    const reason = { ...(revision !== undefined && { revision }), ...(other !== undefined && { author: other }) };
    this.tell(connection, { type: "refused", refusal: { document: this.document, request, errors, ...reason } });
  }

  private publish(sender: Connection, request: string, { revision, author, kind, of, edit }: LogEntry): void {
    const { undo, redo } = this.history.stacksOf(author);
    // As it arrives: another value than the server's.
    const operations = JSON.parse(JSON.stringify(edit.operations)) as readonly Operation[];
    const accepted = { document: this.document, revision, author, message: "", time: 0, kind, ...(of > 0 && { of }), request, operations, errors: [], undo: undo.length, redo: redo.length };
    this.accepted.set(request, accepted);
    this.deltas.push(accepted);
    for (const connection of this.connections) {
      if (connection.isSubscribed && !connection.needsSnapshot) connection.toClient.push({ input: { type: "accepted", edit: accepted }, sequence: this.deltas.length });
      else if (connection === sender && !connection.isSubscribed) this.tell(connection, { type: "acknowledged", edit: accepted });
    }
  }
}
