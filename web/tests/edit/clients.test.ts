// Eight clients edit one document on a simulated server, with delay, loss of connections and deltas, and messages of different clients in
// any order: in the end all have the server's document, and each edit is either in it once or was refused once.
import { expect, it } from "vitest";
import type { StreamRequest } from "../../generated/messages";
import type { JsonObject } from "../../shared/json";
import { writeExact } from "../../shared/edit/exact";
import { newSession, step, type Change, type EditSession, type SessionInput } from "../../shared/edit/session";
import { documentText, treeOf, vector } from "./documents";
import { randomOf, setting, type Random } from "./random";
import { RandomEdits } from "./randomEdits";
import { Connection, SimulatedServer } from "./server/server";

const kDocument = "small";
const small = (vector("apply.remove.json") as { readonly document: JsonObject }).document;

class Client {
  session: EditSession;
  connection: Connection | undefined;
  readonly refused: string[] = [];
  private readonly edits: RandomEdits;
  private seen: number | undefined;
  readonly made: string[] = [];
  /** How many of its connections the server has ended. */
  ended = 0;

  constructor(
    private readonly server: SimulatedServer,
    private readonly random: Random,
    private readonly name: string,
    author: string,
  ) {
    this.session = newSession(kDocument, author);
    this.edits = new RandomEdits(random, `${name}-`);
  }

  private put(input: SessionInput): void {
    const { session, messages, notices } = step(this.session, input);
    this.session = session;
    // As it arrives: a value of its own.
    this.connection?.toServer.push(...(JSON.parse(writeExact(messages)) as readonly StreamRequest[]));
    this.refused.push(...notices.map(({ request }) => request));
  }

  act(): void {
    if (this.session.view === undefined) return;
    const { random } = this;
    const change: Change = random.chance(0.15) ? { undo: true } : random.chance(0.1) ? { redo: true } : this.edits.edit(this.session.view);
    const request = `${this.name}-${this.made.length}`;
    this.made.push(request);
    this.put({ type: "edit", request, change });
  }

  /** The oldest message arrives. */
  receive(): void {
    const told = this.connection?.toClient.shift();
    if (told === undefined) return;
    this.seen = told.sequence ?? this.seen;
    this.put(told.input);
  }

  disconnect(): void {
    if (this.connection === undefined) return;
    this.server.connections.delete(this.connection);
    this.connection = undefined;
    this.put({ type: "connection", connected: false });
  }

  /** Notices that the server has ended the connection; else nothing. */
  notice(): void {
    if (this.connection?.isEnded !== true) return;
    ++this.ended;
    this.disconnect();
  }

  connect(): void {
    if (this.connection !== undefined) return;
    this.connection = new Connection();
    this.server.connections.add(this.connection);
    this.connection.toServer.push({ type: "subscribe", channel: `document/${kDocument}`, ...(this.seen !== undefined && { since: this.seen }) });
    this.put({ type: "connection", connected: true });
  }
}

class EditingSimulation {
  readonly server: SimulatedServer;
  readonly clients: readonly Client[];
  readonly random: Random;

  constructor(seed: number) {
    this.random = randomOf(seed);
    this.server = new SimulatedServer(treeOf(small), kDocument, 20);
    // Two windows of one author among them.
    this.clients = Array.from({ length: 8 }, (_, i) => new Client(this.server, randomOf(seed * 31 + i), `c${i}`, `author${Math.max(1, i)}`));
  }

  act(): void {
    const client = this.random.of(this.clients);
    client.notice();
    const { connection } = client;
    const what = this.random.pick(100);
    if (connection === undefined) {
      if (what < 20) client.connect();
      else if (what < 40) client.act();
      return;
    }
    if (what < 15) client.act();
    else if (what < 55) this.server.receive(connection);
    else if (what < 94) client.receive();
    else if (what < 96) client.disconnect();
    else if (what < 98) this.server.overflow(connection);
    else this.server.catchUp(connection);
  }

  /** Everything arrives. */
  settle(): void {
    for (let isBusy = true; isBusy; ) {
      isBusy = false;
      for (const client of this.clients) {
        client.notice();
        client.connect();
        const { connection } = client;
        if (connection === undefined) continue;
        this.server.catchUp(connection);
        isBusy ||= connection.toServer.length + connection.toClient.length > 0;
        this.server.receive(connection);
        client.receive();
      }
    }
  }
}

it("all clients have the server's document in the end, and each edit is in it once or was refused once", () => {
  const seed = setting("RACE_SEED", 20261122);
  const simulations = setting("RACE_SIMULATIONS", 10);
  let accepted = 0;
  let rejected = 0;
  let ended = 0;
  for (let i = 0; i < simulations; ++i) {
    const repeat = `RACE_SEED=${seed + i} RACE_SIMULATIONS=1`;
    const simulation = new EditingSimulation(seed + i);
    for (let k = 0; k < 3000; ++k) {
      simulation.act();
      if (k % 500 === 499) simulation.settle();
    }
    simulation.settle();
    const { history, requests } = simulation.server;
    for (const { session } of simulation.clients) {
      expect(session.pending, repeat).toEqual([]);
      expect(session.confirmed?.revision, repeat).toBe(history.revision);
      expect(session.view && documentText(session.view), repeat).toBe(documentText(history.tree));
    }
    const refused = simulation.clients.flatMap((client) => client.refused);
    expect([...requests, ...refused].sort(), repeat).toEqual(simulation.clients.flatMap((client) => client.made).sort());
    accepted += requests.length;
    rejected += refused.length;
    ended += simulation.clients.reduce((sum, client) => sum + client.ended, 0);
  }
  console.log(`${accepted} accepted, ${rejected} refused, ${ended} connections ended by the server`);
  expect(accepted).toBeGreaterThan(rejected);
  expect(rejected).toBeGreaterThan(simulations);
  expect(ended).toBeGreaterThan(simulations);
});
