import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { loadInAttempts, pauseAfter } from "../../shared/cell/attempts";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe("loading in attempts", () => {
  /** Fails so many times. */
  function failing(times: number) {
    const told: unknown[] = [];
    let calls = 0;
    const load = () => (++calls > times ? Promise.resolve("world") : Promise.reject(new Error(`no ${calls}`)));
    const end = loadInAttempts(load, { onLoaded: (loaded) => told.push(loaded), onFailed: (error) => told.push(String(error)) });
    return { told, end, calls: () => calls };
  }

  it("tells each failure, and what came in the end, and is done then", async () => {
    const { told, calls } = failing(2);
    await vi.advanceTimersByTimeAsync(60_000);
    expect(told).toEqual(["Error: no 1", "Error: no 2", "world"]);
    expect(calls()).toBe(3);
  });
  it("pauses for longer each time, up to some seconds", () => {
    expect([1, 2, 3, 4, 5, 6, 60].map(pauseAfter)).toEqual([500, 1000, 2000, 4000, 8000, 8000, 8000]);
  });
  it("ends when it is told to, in a pause or while it loads", async () => {
    const pausing = failing(9);
    await vi.advanceTimersByTimeAsync(600);
    pausing.end();
    await vi.advanceTimersByTimeAsync(60_000);
    expect([pausing.told, pausing.calls()]).toEqual([["Error: no 1", "Error: no 2"], 2]);
    const loading = failing(0);
    loading.end();
    await vi.advanceTimersByTimeAsync(0);
    expect(loading.told).toEqual([]);
  });
});
