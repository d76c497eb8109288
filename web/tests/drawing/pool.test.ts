import { describe, expect, it } from "vitest";
import { createPool } from "../../shared/drawing/pool";

/** Work that the test ends. */
function held() {
  let end: () => void = () => undefined;
  const ended = new Promise<void>((resolve) => (end = resolve));
  return { ended, end };
}

describe("createPool", () => {
  it("gives each worker one job at a time, and respects the limit of workers", async () => {
    let made = 0;
    const busy = new Map<number, number>();
    let most = 0;
    const pool = createPool(() => Promise.resolve(++made), 2);
    const work = () =>
      pool(async (worker) => {
        busy.set(worker, (busy.get(worker) ?? 0) + 1);
        most = Math.max(most, ...busy.values());
        await Promise.resolve();
        busy.set(worker, (busy.get(worker) ?? 0) - 1);
        return worker;
      });
    const workers = await Promise.all(Array.from({ length: 9 }, work));
    expect([made, most, new Set(workers).size]).toEqual([2, 1, 2]);
  });
  it("creates no worker while one is free", async () => {
    let made = 0;
    const pool = createPool(() => Promise.resolve(++made), 4);
    for (let i = 0; i < 3; i++) await pool(() => Promise.resolve());
    expect(made).toBe(1);
  });
  it("continues after a job that failed", async () => {
    const pool = createPool(() => Promise.resolve(0), 1);
    await expect(pool(() => Promise.reject(new Error("no layout")))).rejects.toThrow("no layout");
    expect(await pool(() => Promise.resolve("done"))).toBe("done");
  });
  it("rejects work if no worker can be created", async () => {
    const first = held();
    const pool = createPool(() => first.ended.then(() => Promise.reject(new Error("no worker"))), 1);
    const answers = Promise.allSettled([1, 2, 3].map(() => pool(() => Promise.resolve())));
    first.end();
    expect((await answers).map(({ status }) => status)).toEqual(["rejected", "rejected", "rejected"]);
  });
});
