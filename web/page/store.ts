// The stores of the page, what is told of one at a pace, and a hook that selects a part of either.
import { useSyncExternalStore } from "react";
import { slowly as slowlyWith, type Told } from "../shared/slowly";
import { createStore as createStoreWith, type NextFrame, type Store } from "../shared/store";

/** A page that is not seen has no frames: its listeners are notified after this time [ms]. */
const kUnseen = 250;

const nextFrame: NextFrame = (act) => {
  const frame = requestAnimationFrame(act);
  const late = setTimeout(act, kUnseen);
  return () => {
    cancelAnimationFrame(frame);
    clearTimeout(late);
  };
};

export const createStore = <State, Event>(initial: State, apply: (state: State, event: Event) => State): Store<State, Event> => createStoreWith(initial, apply, nextFrame);

/** What goes on by itself is shown so often [ms]: nobody reads more, and to draw it each frame would slow the page down. */
const kReadable = 100;

/** A store for what is read beside the drawing. */
export const slowly = <State>(store: Told<State>, isUrgent: (before: State, now: State) => boolean): Told<State> =>
  slowlyWith(store, kReadable, isUrgent, {
    now: () => performance.now(),
    after: (time, act) => {
      const timer = setTimeout(act, time);
      return () => clearTimeout(timer);
    },
  });

/** The part of a store's state that `select` reads; it must return the same object while nothing changed. */
export function useSelected<State, T>(store: Told<State>, select: (state: State) => T): T {
  return useSyncExternalStore(store.listen, () => select(store.get()));
}
