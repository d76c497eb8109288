// What a client that follows a core has heard of it, without sockets: gaps, folding, and a bounded queue for its reader.
import type { CoreDelta, CoreState } from "../generated/messages.js";
import { fold, isOver } from "./fold.js";
import type { StreamMessage } from "./messages.js";

/** So many updates wait for a slow reader. */
export const kCapacity = 1000;

/**
 * What has happened to a core that is followed. `state`: core and values as they are after it, the same for who has read all updates as
 * for who comes late.
 */
export type Update =
  /** `state` is whole and new. `merged`: so many updates were put together in it, as they came faster than they were read. */
  | { readonly kind: "snapshot"; readonly state: CoreState; readonly merged: number }
  /** `delta` led to `state`. */
  | { readonly kind: "delta"; readonly state: CoreState; readonly delta: CoreDelta }
  /** The connection is lost, for `reason`, and is being made again; `state` is the last that is known. */
  | { readonly kind: "disconnected"; readonly state: CoreState; readonly reason: string }
  /** It is there again, and a snapshot or deltas follow. */
  | { readonly kind: "connected"; readonly state: CoreState };

/** How many updates stand for one. */
const weight = (update: Update): number => (update.kind === "delta" ? 1 : update.kind === "snapshot" ? Math.max(1, update.merged) : 0);

/** The channel core/{id}/state. One side tells it what comes from the server, the other takes updates. */
export class CoreUpdates {
  private queue: Update[] = [];
  private state: CoreState | undefined;
  /** Number of the last message. */
  private last: number | undefined;
  private isLost = false;
  private hasFailed = false;
  private failure: unknown;
  /** Deltas mean nothing until the snapshot comes that was asked for. */
  private hasGap = false;

  constructor(private readonly capacity: number = kCapacity) {}

  /** Whether no more can come: the run is over, or following it has failed. */
  get isOver(): boolean {
    return this.hasFailed || (this.state !== undefined && isOver(this.state.core.status));
  }

  /** Whether a snapshot has ever come. */
  get hasState(): boolean {
    return this.state !== undefined;
  }

  /** Whether the server owes a snapshot for a gap: nothing else it sends means anything. */
  get needsSnapshot(): boolean {
    return this.hasGap;
  }

  /** There is a connection. */
  opened(): void {
    if (this.isLost && this.state !== undefined) this.put({ kind: "connected", state: this.state });
    this.isLost = false;
  }

  /** The connection has ended; each further time, another attempt to make it has. */
  lost(reason: string): void {
    if (!this.isLost && this.state !== undefined) this.put({ kind: "disconnected", state: this.state, reason });
    this.isLost = true;
  }

  /** Nothing more can be heard, for this reason; the reader gets it behind all updates. */
  fail(error: unknown): void {
    if (!this.hasFailed) [this.hasFailed, this.failure] = [true, error];
  }

  /** A message of the channel; true: there is a gap, for which a snapshot is to be asked. */
  receive({ update, sequence }: StreamMessage): boolean {
    if (update.type === "state") {
      this.hasGap = false;
      this.state = update.state;
      this.put({ kind: "snapshot", state: update.state, merged: 0 });
    } else if (update.type !== "state_changed" || this.hasGap) {
      return false;
    } else if (this.state === undefined || this.last === undefined || sequence !== this.last + 1) {
      this.hasGap = true;
      return true;
    } else {
      this.state = fold(this.state, update.delta);
      this.put({ kind: "delta", state: this.state, delta: update.delta });
    }
    this.last = sequence;
    return false;
  }

  /** The next update; nothing: there is none now. Throws the reason of `fail` when all updates before it were read. */
  pop(): Update | undefined {
    if (this.queue.length === 0 && this.hasFailed) throw this.failure;
    return this.queue.shift();
  }

  /** Behind the others; if there are too many, one snapshot takes the place of all, behind the last news of the connection. */
  private put(update: Update): void {
    this.queue.push(update);
    if (this.queue.length <= this.capacity) return;
    const news = this.queue.filter(({ kind }) => kind === "disconnected" || kind === "connected").slice(-2);
    const merged = this.queue.reduce((sum, each) => sum + weight(each), 0);
    this.queue = [...news, { kind: "snapshot", state: update.state, merged }];
  }
}
