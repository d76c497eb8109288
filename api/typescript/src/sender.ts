// What documents, cores, runs and services need of a client.
import type { Call } from "./call.js";
import { RaceError } from "./errors.js";
import type { Derivations, TraceStep } from "./generated/messages.js";
import type { Following, FollowOptions } from "./stream/following.js";

/** The limits of one request. */
export interface SendOptions {
  /** [s] for its answer; nothing: those of the client. */
  readonly timeout?: number | undefined;
  /** Aborts it. */
  readonly signal?: AbortSignal | undefined;
}

/** A client, or the part of one. */
export interface Sender {
  send<Answer>(call: Call<Answer>, options?: SendOptions): Promise<Answer>;
  follow(core: string, options?: FollowOptions): Promise<Following>;
}

/** Macro steps of an answer with derivations, at most (openapi.yaml). */
const kPage = 100;

/** A revision as If-Match has it. */
export const tagOf = (revision: number | undefined): string | undefined => (revision === undefined ? undefined : `"${revision}"`);

/** A request with a key or token of its own, by which the server does it once: if its answer does not come, it is sent again. */
export async function sendTwice<Answer>(sender: Pick<Sender, "send">, call: Call<Answer>, options?: SendOptions): Promise<Answer> {
  try {
    return await sender.send(call, options);
  } catch (error) {
    if (!(error instanceof RaceError && error.mayBeDone)) throw error;
  }
  try {
    return await sender.send(call, options);
  } catch (error) {
    if (error instanceof RaceError && error.status === 0) error.mayBeDone = true; // by the first time
    throw error;
  }
}

/** Macro steps `first` to `last`. */
export async function* derivationPages(page: (from: number, to: number) => Promise<Derivations>, first: number, last: number): AsyncGenerator<TraceStep, void> {
  for (let next = first; next <= last; ) {
    const { steps } = await page(next, Math.min(last, next + kPage - 1));
    yield* steps;
    const end = steps.at(-1);
    if (end === undefined) return;
    next = end.step + 1;
  }
}

