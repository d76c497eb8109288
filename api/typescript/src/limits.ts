// Time limits.
import { failure, kTimeout } from "./errors.js";

/** A timer takes no more [ms]. */
const kLongest = 2 ** 31 - 1;

/** Calls `act` after so many seconds; the result ends that. */
export function after(seconds: number, act: () => void): () => void {
  const timer = setTimeout(act, Math.min(seconds * 1000, kLongest));
  return () => clearTimeout(timer);
}

export const pause = (seconds: number): Promise<void> => new Promise((resolve) => void after(seconds, resolve));

/** What `act` comes to: its signal is aborted after so many seconds (undefined: never), and when `signal` is. */
export async function within<T>(seconds: number | undefined, signal: AbortSignal | undefined, act: (signal: AbortSignal) => Promise<T>): Promise<T> {
  const both = new AbortController();
  const forward = () => both.abort(signal?.reason);
  const end = seconds === undefined ? undefined : after(seconds, () => both.abort(failure(kTimeout, `not done within ${seconds} s`)));
  if (signal?.aborted === true) forward();
  else signal?.addEventListener("abort", forward, { once: true });
  try {
    return await act(both.signal);
  } finally {
    end?.();
    signal?.removeEventListener("abort", forward);
  }
}
