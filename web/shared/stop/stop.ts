// The stop of a page: what is known of it, its press, and its reset. It needs no login and no stream.
import { isRefusal } from "../../../api/typescript/src/errors";
import { withToken } from "../../../api/typescript/src/request";
import type { Control } from "../../generated/messages";
import { createStore, type NextFrame } from "../store";
import type { Connection } from "../stream";
import { stopAddresses, type Place } from "./addresses";
import { getControl, resetStop } from "./requests";
import { kPatience, sendStop, type Sending } from "./sending";
import { applyStop, kFirstStop, type StopEvent, type StopState } from "./state";

export interface StopOptions {
  readonly place: Place;
  readonly fetcher: typeof fetch;
  /** Of the account, if somebody is logged in: then the stop has their name. */
  readonly token: () => string | undefined;
  readonly after: (time: number, act: () => void) => void;
  /** [ms since 1970] */
  readonly now: () => number;
  readonly nextFrame: NextFrame;
}

/** Without a stream, the server is asked so often [ms]. */
export const kAsk = 3000;
/** An answer that takes longer is none [ms]. */
const kAnswer = 5000;

export function createStop({ place, fetcher, token, after, now, nextFrame }: StopOptions) {
  const store = createStore<StopState, StopEvent>(kFirstStop, applyStop, nextFrame);
  let isStreamed = false;
  /** Presses of which something may still be on its way. */
  const sendings = new Set<Sending>();
  let last: Sending | undefined;

  const take = (control: Control): void => store.dispatch({ type: "told", control });
  /** To the server of the page; to another port it would be one more request, which asks whether it may be sent. */
  const named = withToken(fetcher, token);

  async function ask(): Promise<void> {
    try {
      take(await getControl(named, AbortSignal.timeout(kAnswer)));
    } catch (error) {
      if (!isRefusal(error) && !isStreamed) store.dispatch({ type: "lost" });
    }
  }
  async function askOn(): Promise<void> {
    if (!isStreamed) await ask();
    after(kAsk, () => void askOn());
  }

  /** By itself, not as a call: also to other ports, and what is answered does not matter. */
  async function post(address: string, signal: AbortSignal): Promise<void> {
    const answer = await (address.startsWith("/") ? named : fetcher)(address, { method: "POST", signal });
    if (!answer.ok) throw new Error(`status ${answer.status}`);
  }

  /** Of several presses, the last one tells that it failed; each tells that it was answered. */
  async function press(): Promise<void> {
    store.dispatch({ type: "pressed" });
    const sending: Sending = sendStop({ addresses: () => stopAddresses(place, store.get().ports), post, after, now, onLate: () => sending === last && store.dispatch({ type: "late" }) });
    last = sending;
    sendings.add(sending);
    after(kPatience, () => sendings.delete(sending));
    if (await sending.answered) {
      store.dispatch({ type: "answered", time: now() });
      await ask();
    } else if (sending === last) store.dispatch({ type: "failed" });
  }

  return {
    get: store.get,
    listen: store.listen,
    /** Asks the server from now on, while no stream tells. To be called once. */
    begin: (): void => void askOn(),
    press: (): void => void press(),
    /** Somebody has read that the stop failed. */
    dismiss: (): void => store.dispatch({ type: "read" }),
    /** From the channel `control`. */
    take,
    /** This page has the controls, or no more. */
    hold: (number: number | undefined): void => store.dispatch({ type: "held", number }),
    /** Of the stream that has that channel. */
    connection: (connection: Connection): void => {
      isStreamed = connection === "open";
      if (connection === "open") void ask(); // another server may serve it at another port
      else if (connection === "lost") store.dispatch({ type: "lost" });
    },
    /** Throws why the server refuses it. What is left of a stop is given up before, so that it does not come after the reset. */
    reset: async (authorized: typeof fetch): Promise<void> => {
      last = undefined;
      sendings.forEach((sending) => sending.end());
      store.dispatch({ type: "withdrawn" });
      take(await resetStop(authorized));
    },
  };
}

export type StopControl = ReturnType<typeof createStop>;
