// A store around a pure function: holds a value, notifies its listeners of changes; with a hook that selects a part of it.
import { useSyncExternalStore } from "react";

export interface Store<State, Event> {
  readonly get: () => State;
  readonly dispatch: (event: Event) => void;
  readonly listen: (listener: () => void) => () => void;
}

export function createStore<State, Event>(initial: State, apply: (state: State, event: Event) => State): Store<State, Event> {
  let state = initial;
  const listeners = new Set<() => void>();
  return {
    get: () => state,
    dispatch(event) {
      const next = apply(state, event);
      if (next === state) return;
      state = next;
      listeners.forEach((listener) => listener());
    },
    listen(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}

/** The part of a store's state that `select` reads; it must return the same object while nothing changed. */
export function useSelected<State, Event, T>(store: Store<State, Event>, select: (state: State) => T): T {
  return useSyncExternalStore(store.listen, () => select(store.get()));
}
