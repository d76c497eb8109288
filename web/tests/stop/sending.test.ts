import { describe, expect, it } from "vitest";
import { kPatience, sendStop } from "../../shared/stop/sending";
import { fakeTime } from "./timers";

type Answer = (address: string, signal: AbortSignal) => Promise<void>;
const never: Answer = () => new Promise(() => undefined);
const refused: Answer = () => Promise.reject(new Error("lost"));

function pressed(post: Answer) {
  const time = fakeTime();
  const sent: (readonly [number, string])[] = [];
  const signals = new Set<AbortSignal>();
  let late = 0;
  let result: boolean | undefined;
  const sending = sendStop({
    addresses: () => ["own", "ordinary"],
    post: (address, signal) => {
      sent.push([time.now(), address]);
      signals.add(signal);
      return post(address, signal);
    },
    after: time.after,
    now: time.now,
    onLate: () => late++,
  });
  void sending.answered.then((answered) => (result = answered));
  return { time, sent, sending, late: () => late, result: () => result, isOver: () => [...signals].every(({ aborted }) => aborted) };
}

describe("a stop", () => {
  it("goes to both addresses at once", () => expect(pressed(never).sent).toEqual([[0, "own"], [0, "ordinary"]]));

  it.each(["own", "ordinary"])("is answered if %s answers, and is not sent again", async (which) => {
    const { time, sent, result, late } = pressed((address, signal) => (address === which ? Promise.resolve() : never(address, signal)));
    await time.settle();
    expect(result()).toBe(true);
    await time.pass(4000);
    expect([sent.length, late()]).toEqual([2, 0]);
  });

  it("is sent again every half second while nothing answers, each time to both", async () => {
    const { time, sent, late } = pressed(refused);
    await time.pass(1100);
    expect(sent.map(([at]) => at)).toEqual([0, 0, 500, 500, 1000, 1000]);
    expect(late()).toBe(2);
  });

  it("is answered by a later attempt", async () => {
    let attempts = 0;
    const { time, result } = pressed((address, signal) => (++attempts > 4 ? Promise.resolve() : refused(address, signal)));
    await time.pass(999);
    expect(result()).toBeUndefined();
    await time.pass(1);
    expect(result()).toBe(true);
  });

  it("is given up after five seconds: nothing of it is on its way any more", async () => {
    const { time, sent, result, isOver } = pressed(never);
    await time.pass(kPatience - 1);
    expect([result(), isOver()]).toEqual([undefined, false]);
    await time.pass(1);
    expect([result(), isOver(), sent.length]).toEqual([false, true, 20]);
    await time.pass(60_000);
    expect(sent.length).toBe(20);
  });

  it("does not come late from the address that did not answer, once the other one has", async () => {
    const { time, isOver } = pressed((address, signal) => (address === "own" ? Promise.resolve() : never(address, signal)));
    await time.pass(kPatience);
    expect(isOver()).toBe(true);
  });

  it("is not sent by a device that wakes up long after", async () => {
    const { time, sent, result } = pressed(refused);
    time.sleep(60_000);
    await time.pass(0);
    expect([sent.length, result()]).toEqual([2, false]);
  });

  it("is taken back", async () => {
    const { time, sent, sending, result, isOver } = pressed(never);
    sending.end();
    await time.pass(1000);
    expect([sent.length, result(), isOver()]).toEqual([2, false, true]);
  });
});
