// Stores: the state is always the latest; listeners are told at once, or once for all of a frame.
import { describe, expect, it } from "vitest";
import { createStore } from "../shared/store";

function fixture() {
  let next: (() => void) | undefined;
  const store = createStore<readonly string[], string>([], (state, event) => (event === "nothing" ? state : [...state, event]), (act) => {
    next = act;
    return () => (next = undefined);
  });
  const told: (readonly string[])[] = [];
  store.listen(() => told.push(store.get()));
  return { store, told, frame: () => next?.(), waits: () => next !== undefined };
}

describe("a store", () => {
  it("tells of each change at once, and of none where nothing has changed", () => {
    const { store, told } = fixture();
    for (const event of ["a", "nothing", "b"]) store.dispatch(event);
    expect(told).toEqual([["a"], ["a", "b"]]);
  });
  it("tells once of all changes of a frame, and has them before, in order", () => {
    const { store, told, frame } = fixture();
    const frames: number[] = [];
    for (const event of ["a", "b", "c"]) store.dispatchInFrame((number) => (frames.push(number), event));
    expect(store.get()).toEqual(["a", "b", "c"]);
    expect(told).toEqual([]);
    frame();
    expect(told).toEqual([["a", "b", "c"]]);
    store.dispatchInFrame((number) => (frames.push(number), "d"));
    frame();
    expect(told.length).toBe(2);
    expect(frames).toEqual([0, 0, 0, 1]);
  });
  it("tells what has waited for a frame with a change that does not wait, and not again", () => {
    const { store, told, frame, waits } = fixture();
    store.dispatchInFrame(() => "a");
    store.dispatch("b");
    expect(told).toEqual([["a", "b"]]);
    expect(waits()).toBe(false);
    frame();
    expect(told.length).toBe(1);
  });
  it("asks for no frame where nothing has changed", () => {
    const { store, waits } = fixture();
    store.dispatchInFrame(() => "nothing");
    expect(waits()).toBe(false);
  });
});
