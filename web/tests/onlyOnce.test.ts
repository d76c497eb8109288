// One start by one press, with the clock of the test.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { kSamePress, onlyOnce } from "../shared/onlyOnce";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function fixture(settle = kSamePress) {
  const told: boolean[] = [];
  let begun = 0;
  const once = onlyOnce({ settle, after: (time, act) => void setTimeout(act, time), onChange: (isBusy) => told.push(isBusy) });
  /** A press whose request is answered after so many ms. */
  const press = (time: number): void =>
    void once(() => {
      begun++;
      return new Promise<void>((resolve) => setTimeout(resolve, time));
    });
  return { once, told, press, begun: () => begun };
}

const wait = (time: number) => vi.advanceTimersByTimeAsync(time);

describe("a start", () => {
  it("is one for all presses while its request is on its way", async () => {
    const { told, press, begun } = fixture();
    for (let i = 0; i < 6; i++) {
      press(4 * kSamePress);
      await wait(kSamePress / 2);
    }
    expect([begun(), told]).toEqual([1, [true]]);
    await wait(kSamePress);
    expect(told).toEqual([true, false]);
    press(1);
    expect(begun()).toBe(2);
  });

  it("is one for a double click whose first press is answered before the second", async () => {
    const { told, press, begun } = fixture();
    press(5);
    await wait(kSamePress / 4);
    press(5);
    expect([begun(), told]).toEqual([1, [true]]);
    await wait(kSamePress);
    expect(told).toEqual([true, false]);
  });

  it("is there again at once where a press says for itself that it is another one", async () => {
    const { press, begun } = fixture(0);
    press(5);
    press(5);
    await wait(10);
    press(5);
    expect(begun()).toBe(2);
  });

  it("can be tried again when it was refused, and says why to the one who pressed", async () => {
    const { once, press, begun } = fixture();
    await expect(once(() => Promise.reject(new Error("no")))).rejects.toThrow("no");
    await wait(kSamePress);
    press(5);
    expect(begun()).toBe(1);
  });
});
