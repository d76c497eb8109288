// What changes many times a second, told at a pace that can be read and drawn; what people wait for is told at once.
import type { Store } from "./store";

export interface Clock {
  /** [ms], from any moment. */
  readonly now: () => number;
  /** Calls `act` after this time [ms]; the result prevents that. */
  readonly after: (time: number, act: () => void) => () => void;
}

export type Told<State> = Pick<Store<State, never>, "get" | "listen">;

/** `source` at a pace: of changes that come faster than one in `period` [ms], listeners hear together at its next multiple of the clock, so of several
 *  sources in one frame, which lays the page out once; of one after a rest they hear at once. Of a change that `isUrgent` they always hear at once. `get` gives what was told last, so that all who listen show the same moment. */
export function slowly<State>(source: Told<State>, period: number, isUrgent: (before: State, now: State) => boolean, clock: Clock): Told<State> {
  let told = source.get();
  let last = -Infinity;
  let cancel: (() => void) | undefined;
  const listeners = new Set<() => void>();
  const stopWaiting = () => {
    cancel?.();
    cancel = undefined;
  };
  const tell = () => {
    stopWaiting();
    last = clock.now();
    told = source.get();
    listeners.forEach((listener) => listener());
  };
  source.listen(() => {
    const now = source.get();
    const time = clock.now();
    if (now === told) stopWaiting();
    else if (time >= last + period || isUrgent(told, now)) tell();
    else cancel ??= clock.after(period - (time % period), tell);
  });
  return {
    get: () => told,
    listen(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
