// A core that is followed over the stream.
import { failure, isTimeout, kConnection, kProtocol, kTimeout, RaceError } from "../errors.js";
import { after } from "../limits.js";
import type { StreamMessage, StreamUpdate } from "./messages.js";
import { socketConstructor, type SocketConstructor } from "./socket.js";
import { openStream, type Connection, type Stream } from "./stream.js";
import { CoreUpdates, type Update } from "./updates.js";

export interface FollowOptions {
  /** [s] without an update after which the reader gets a RaceError `timeout`. Nothing: never, for a run may do nothing for long. */
  readonly quiet?: number | undefined;
  /** [s] for which a lost connection is made again: 60. */
  readonly patience?: number | undefined;
  /** So many updates wait for a slow reader until they are put together: 1000. */
  readonly capacity?: number | undefined;
  /** [s] for the first snapshot: three times the client's. */
  readonly within?: number | undefined;
  /** Ends it: the reader gets its reason. */
  readonly signal?: AbortSignal | undefined;
}

/** What following needs of a client. */
export interface FollowedServer {
  /** For messages. */
  readonly where: string;
  /** [s] for an answer. */
  readonly timeout: number;
  /** Of the stream, for one connection. Rejects with a RaceError if the server gives none. */
  readonly streamAddress: () => Promise<string>;
  /** Asks whether the server answers; rejects if it does not in time. */
  readonly ask: () => Promise<unknown>;
  readonly webSocket: SocketConstructor | undefined;
}

/** Without a word of the server for so long, it is asked whether it is there [s]. */
const kSilence = 20;
/** Between two looks at that [s]. */
const kLook = 5;
/** Between attempts to connect again [ms]: the first, and the longest; each is twice as long as the one before. */
const kDelay = { first: 100, longest: 2000 };

/** Whether another attempt may do better. */
export const passes = (error: unknown): boolean => error instanceof RaceError && (error.code === kConnection || error.code === kTimeout || error.code === "unavailable");

/**
 * The updates of a core: a snapshot, then deltas, until its run is over; an iterator, which is closed by its end.
 *
 * It listens beside its reader, so a slow one does not lose the connection: beyond `capacity` updates that wait, one snapshot takes the
 * place of all (`merged`). A connection that is lost is made again, for `patience` seconds, and what was missed comes then, or a new
 * snapshot; the updates `disconnected` and `connected` say so. After that, and for what no attempt will change (rights, no such core),
 * `next` rejects with a RaceError, behind all updates that came before.
 */
export class Following implements AsyncIterableIterator<Update> {
  private readonly channel: string;
  private readonly updates: CoreUpdates;
  private readonly stream: Stream;
  private readonly wakes = new Set<() => void>();
  private readonly endWatch: () => void;
  private endPatience: (() => void) | undefined;
  private endDebt: (() => void) | undefined;
  private reason: RaceError | undefined;
  private isConnected = false;
  private isClosed = false;
  private isAsking = false;
  private heard = Date.now();

  /** Connects. `openFollowing` also waits for the first snapshot. */
  constructor(
    private readonly server: FollowedServer,
    private readonly core: string,
    private readonly options: FollowOptions,
  ) {
    this.channel = `core/${core}/state`;
    this.updates = new CoreUpdates(options.capacity);
    const delay = (attempt: number) => Math.min(kDelay.longest, kDelay.first * 2 ** attempt);
    const handlers = {
      onConnection: (connection: Connection) => this.onConnection(connection),
      onUpdate: (update: StreamUpdate, message: StreamMessage) => this.onUpdate(update, message),
      onMalformed: (error: Error) => this.fail(failure(kProtocol, `${server.where} sends what is no message of the stream: ${error.message}`)),
    };
    const webSocket = socketConstructor(server.webSocket);
    this.stream = openStream(() => this.address(), handlers, { webSocket, delay });
    this.stream.subscribe(this.channel);
    const timer = setInterval(() => void this.look(), kLook * 1000);
    this.endWatch = () => clearInterval(timer);
    options.signal?.addEventListener("abort", this.onAbort, { once: true });
    if (options.signal?.aborted === true) this.onAbort();
  }

  [Symbol.asyncIterator](): this {
    return this;
  }

  /** The next update. Rejects with a RaceError `timeout` if none comes for `quiet` seconds. */
  async next(): Promise<IteratorResult<Update, undefined>> {
    const value = await this.take(this.options.quiet);
    return value === undefined ? { done: true, value } : { done: false, value };
  }

  /** Of an iteration that ends before the run. */
  return(): Promise<IteratorResult<Update, undefined>> {
    this.close();
    return Promise.resolve({ done: true, value: undefined });
  }

  /** The next update within so many seconds (undefined: at any time); nothing: the run is over, or this is closed, and all was read. */
  async take(seconds?: number): Promise<Update | undefined> {
    let isLate = false;
    const end = seconds === undefined ? undefined : after(seconds, () => {
      isLate = true;
      this.wake();
    });
    const late = () => isLate;
    try {
      for (;;) {
        const isDone = this.isClosed || this.updates.isOver;
        const update = this.updates.pop();
        if (update !== undefined || isDone) return update;
        if (late()) throw failure(kTimeout, `core ${this.core}: no update within ${seconds ?? 0} s`);
        await new Promise<void>((resolve) => this.wakes.add(resolve));
      }
    } finally {
      end?.();
    }
  }

  /** Until the first snapshot is there, so that nothing is missed of what is done then. Rejects with why it does not come. */
  async opened(): Promise<this> {
    const seconds = this.options.within ?? 3 * this.server.timeout;
    const end = after(seconds, () => this.fail(failure(kTimeout, `${this.server.where} does not answer in time`)));
    try {
      while (!this.updates.hasState) {
        if (this.updates.isOver) this.updates.pop(); // throws
        await new Promise<void>((resolve) => this.wakes.add(resolve));
      }
      return this;
    } finally {
      end();
    }
  }

  /** Ends it, also within an iteration. */
  close(): void {
    this.isClosed = true;
    this.disconnect();
    this.wake();
  }

  private readonly onAbort = (): void => this.fail(this.options.signal?.reason);

  private wake(): void {
    const woken = [...this.wakes];
    this.wakes.clear();
    woken.forEach((resolve) => resolve());
  }

  private fail(error: unknown): void {
    this.updates.fail(error);
    this.disconnect();
    this.wake();
  }

  private disconnect(): void {
    this.endWatch();
    this.endPatience?.();
    this.endDebt?.();
    this.options.signal?.removeEventListener("abort", this.onAbort);
    this.stream.close();
  }

  private async address(): Promise<string> {
    try {
      return await this.server.streamAddress();
    } catch (error) {
      if (error instanceof RaceError) this.reason = error;
      if (!passes(error)) this.fail(error);
      throw error;
    }
  }

  private onConnection(connection: Connection): void {
    if (connection === "connecting") return;
    this.isConnected = connection === "open";
    this.heard = Date.now();
    if (this.isConnected) {
      this.endPatience?.();
      this.endPatience = undefined;
      this.reason = undefined;
      this.updates.opened();
      if (this.updates.needsSnapshot) this.askForSnapshot();
    } else this.onLost();
    this.wake();
  }

  private onLost(): void {
    const { where } = this.server;
    const reason = this.reason ?? failure(kConnection, `${where} has closed the connection`);
    if (!this.updates.hasState) {
      this.fail(reason);
      return;
    }
    this.updates.lost(reason.message);
    const { patience = 60 } = this.options;
    this.endPatience ??= after(patience, () => this.fail(this.reason ?? failure(kConnection, `${where} cannot be reached`)));
  }

  private onUpdate(update: StreamUpdate, message: StreamMessage): void {
    this.heard = Date.now();
    if (update.type === "refused") {
      this.fail(new RaceError(0, update.errors));
      return;
    }
    if (this.updates.receive(message)) this.askForSnapshot();
    if (!this.updates.needsSnapshot) this.endDebt?.();
    if (this.updates.isOver) this.disconnect();
    this.wake();
  }

  /** Once more from the beginning; a server that sends no snapshot in time is as good as lost. */
  private askForSnapshot(): void {
    this.stream.unsubscribe(this.channel);
    this.stream.subscribe(this.channel);
    this.endDebt?.();
    this.endDebt = after(this.server.timeout, () => this.stream.abandon());
  }

  /** A network that is gone says nothing for minutes. */
  private async look(): Promise<void> {
    if (!this.isConnected || this.isAsking || Date.now() - this.heard < kSilence * 1000) return;
    this.isAsking = true;
    try {
      await this.server.ask();
      this.heard = Date.now();
    } catch (error) {
      if (isTimeout(error) || passes(error)) this.stream.abandon();
    } finally {
      this.isAsking = false;
    }
  }
}

/** Follows a core; resolves when its first snapshot is there. Rejects with why there is none: no server, no such core, no rights. */
export async function openFollowing(server: FollowedServer, core: string, options: FollowOptions = {}): Promise<Following> {
  const following = new Following(server, core, options);
  try {
    return await following.opened();
  } catch (error) {
    following.close();
    throw error;
  }
}
