// Told at a pace: the first change after a rest and urgent ones at once, others together, the last one always.
import { describe, expect, it } from "vitest";
import { slowly } from "../shared/slowly";
import { createStore } from "../shared/store";

const kPeriod = 100;

function fixture() {
  let now = 1000;
  let waiting: { readonly at: number; readonly act: () => void } | undefined;
  const source = createStore<string, string>("", (_, text) => text, (act) => (act(), () => undefined));
  const told = slowly(source, kPeriod, (_, text) => text.endsWith("!"), {
    now: () => now,
    after(time, act) {
      const mine = { at: now + time, act };
      if (waiting !== undefined) throw new Error("two timers wait");
      waiting = mine;
      return () => {
        if (waiting === mine) waiting = undefined;
      };
    },
  });
  const heard: (readonly [at: number, text: string])[] = [];
  told.listen(() => heard.push([now - 1000, told.get()]));
  /** Moves on to a time after the beginning. */
  const until = (time: number) => {
    for (let next = waiting; next !== undefined && next.at <= 1000 + time; next = waiting) {
      now = next.at;
      waiting = undefined;
      next.act();
    }
    now = 1000 + time;
  };
  return { source, told, heard, until, waits: () => waiting !== undefined };
}

describe("slowly", () => {
  it("tells of a change after a rest at once", () => {
    const { source, heard, until } = fixture();
    source.dispatch("a");
    until(kPeriod);
    source.dispatch("b");
    expect(heard).toEqual([[0, "a"], [kPeriod, "b"]]);
  });
  it("tells together what comes within a period, and always the last of it", () => {
    const { source, told, heard, until, waits } = fixture();
    for (let time = 0; time <= 230; time += 10) {
      until(time);
      source.dispatch(`at ${time}`);
      expect(told.get()).toBe(heard.at(-1)?.[1]);
    }
    until(1000);
    expect(heard).toEqual([[0, "at 0"], [100, "at 90"], [200, "at 190"], [300, "at 230"]]);
    expect(waits()).toBe(false);
  });
  it("tells what is urgent at once, with what waits, and not again", () => {
    const { source, heard, until, waits } = fixture();
    source.dispatch("a");
    until(10);
    source.dispatch("b");
    until(20);
    source.dispatch("c!");
    expect(heard).toEqual([[0, "a"], [20, "c!"]]);
    expect(waits()).toBe(false);
    until(30);
    source.dispatch("d");
    until(1000);
    expect(heard.slice(2)).toEqual([[100, "d"]]);
  });
  it("tells nothing of what is again as it was told", () => {
    const { source, heard, until } = fixture();
    for (const text of ["a", "b", "a"]) source.dispatch(text);
    until(1000);
    expect(heard).toEqual([[0, "a"]]);
  });
  it("ends telling a listener", () => {
    const { source, told } = fixture();
    let count = 0;
    const end = told.listen(() => count++);
    source.dispatch("a!");
    end();
    source.dispatch("b!");
    expect(count).toBe(1);
  });
});
