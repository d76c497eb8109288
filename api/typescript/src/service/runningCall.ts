// A call while it is at work: whether anybody waits for it, and how its work learns that nobody does.
import type { JsonObject, JsonValue } from "../json.js";
import { after } from "../limits.js";
import type { RunningCall } from "./operation.js";
import type { Transition } from "./rsm.js";
import { Stopped } from "./service.js";

/** Waits that end when the signal is aborted, by a rejection with Stopped. */
function pausing(signal: AbortSignal): RunningCall["pause"] {
  return (seconds) =>
    new Promise((resolve, reject) => {
      const stop = () => {
        cancel();
        reject(new Stopped());
      };
      const cancel = after(seconds, () => {
        signal.removeEventListener("abort", stop);
        resolve();
      });
      if (signal.aborted) stop();
      else signal.addEventListener("abort", stop, { once: true });
    });
}

/** What an operation gets that can be stopped by `stop`. */
export function stoppable(): { readonly running: RunningCall; readonly stop: () => void } {
  const aborter = new AbortController();
  const { signal } = aborter;
  return { running: { signal, pause: pausing(signal) }, stop: () => aborter.abort(new Stopped()) };
}

export class Call {
  /** Nobody waits for its answer any more. */
  isOver = false;
  private readonly inner = stoppable();

  constructor(
    readonly number: number,
    readonly operation: string,
    /** That took it; nothing: the service has no states. */
    readonly transition: Transition | undefined,
  ) {}

  get running(): RunningCall {
    return this.inner.running;
  }

  /** Its work is to end, if it looks at its signal, or pauses. */
  stop(): void {
    this.isOver = true;
    this.inner.stop();
  }
}

/** What is done at most for so many seconds; then its signal is aborted. Rejects if it does not end in time, or fails. */
export async function atMost(seconds: number, act: (running: RunningCall) => unknown): Promise<void> {
  const { running, stop } = stoppable();
  let cancel: () => void = () => undefined;
  const late = new Promise<never>((_, reject) => {
    cancel = after(seconds, () => {
      stop();
      reject(new Error(`it does not end within ${seconds} s`));
    });
  });
  try {
    await Promise.race([Promise.resolve(running).then(act), late]);
  } finally {
    cancel();
  }
}

/** How a call is answered. */
export type Outcome = { readonly value: JsonValue; readonly error?: undefined } | { readonly error: JsonObject & { readonly code: string } };
