// The stores of the page, and a hook that selects a part of one.
import { useSyncExternalStore } from "react";
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

/** The part of a store's state that `select` reads; it must return the same object while nothing changed. */
export function useSelected<State, Event, T>(store: Store<State, Event>, select: (state: State) => T): T {
  return useSyncExternalStore(store.listen, () => select(store.get()));
}
