// A store around a pure function: holds a value, and notifies its listeners of changes; at once, or once for all of a frame of the page.

export interface Store<State, Event> {
  /** Always the latest. */
  readonly get: () => State;
  readonly dispatch: (event: Event) => void;
  /** The listeners are notified with the next frame, once for all that has changed until then. `make` gets the number of that frame. */
  readonly dispatchInFrame: (make: (frame: number) => Event) => void;
  readonly listen: (listener: () => void) => () => void;
}

/** Calls `act` with the next frame; the result prevents that. */
export type NextFrame = (act: () => void) => () => void;

export function createStore<State, Event>(initial: State, apply: (state: State, event: Event) => State, nextFrame: NextFrame): Store<State, Event> {
  let state = initial;
  let frame = 0;
  let cancel: (() => void) | undefined;
  const listeners = new Set<() => void>();
  const change = (event: Event): boolean => {
    const next = apply(state, event);
    if (next === state) return false;
    state = next;
    return true;
  };
  const notify = () => {
    cancel?.();
    cancel = undefined;
    frame++;
    listeners.forEach((listener) => listener());
  };
  return {
    get: () => state,
    dispatch(event) {
      if (change(event)) notify();
    },
    dispatchInFrame(make) {
      if (change(make(frame))) cancel ??= nextFrame(notify);
    },
    listen(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
