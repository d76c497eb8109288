// The stop of this page.
import { useSyncExternalStore } from "react";
import { storedTokens } from "../shared/login/tokens";
import { createStop } from "../shared/stop/stop";
import type { StopState } from "../shared/stop/state";

export const stop = createStop({
  place: location,
  fetcher: (input, init) => fetch(input, init),
  token: storedTokens(() => localStorage, window).read,
  after: (time, act) => void setTimeout(act, time),
  now: () => Date.now(),
  nextFrame: (act) => {
    const frame = requestAnimationFrame(act);
    return () => cancelAnimationFrame(frame);
  },
});

/** The part that `select` reads; it must return the same object while nothing changed. */
export const useStop = <T>(select: (state: StopState) => T): T => useSyncExternalStore(stop.listen, () => select(stop.get()));
