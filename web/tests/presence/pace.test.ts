import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { kHeartbeat, kPeriod, openPace } from "../../shared/presence/pace";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function opened() {
  const at = { value: 0, awake: true };
  const sent: number[] = [];
  const pace = openPace(() => at.value, (value) => sent.push(value), () => at.awake);
  const set = (value: number) => {
    at.value = value;
    pace.changed();
  };
  return { at, sent, pace, set };
}

describe("what a person does", () => {
  it("is sent at once, then at most 25 times in a second, the last of it always", () => {
    const { sent, set } = opened();
    set(1);
    expect(sent).toEqual([1]);
    for (let i = 2; i <= 1000; ++i) {
      set(i);
      vi.advanceTimersByTime(1);
    }
    vi.advanceTimersByTime(kPeriod);
    expect(sent.length).toBeLessThanOrEqual(1 + 1000 / kPeriod);
    expect(sent.at(-1)).toBe(1000);
  });

  it("is not sent again while it stays the same, but for a sign of life", () => {
    const { sent, set } = opened();
    set(1);
    set(1);
    vi.advanceTimersByTime(kHeartbeat - 1);
    expect(sent).toEqual([1]);
    vi.advanceTimersByTime(1);
    expect(sent).toEqual([1, 1]);
  });

  it("is not told while the page sleeps, and at once when it is seen again", () => {
    const { at, sent, pace, set } = opened();
    set(1);
    at.awake = false;
    vi.advanceTimersByTime(5 * kHeartbeat);
    expect(sent).toEqual([1]);
    pace.renew();
    expect(sent).toEqual([1, 1]);
  });

  it("ends", () => {
    const { sent, pace, set } = opened();
    set(1);
    set(2);
    pace.close();
    vi.advanceTimersByTime(5 * kHeartbeat);
    expect(sent).toEqual([1]);
  });
});
