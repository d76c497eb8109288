// Whether the server answers, on a page whose clock is of the test.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { kAsk, kFailures, kLook, kPatience, watchReach } from "../shared/reach";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** Until silence is certain, and a little more [ms]. */
const kCertain = kAsk + kFailures * kPatience + 3 * kLook;

const there = () => Promise.resolve(new Response("", { status: 503 }));
const refused = () => Promise.reject(new TypeError("Failed to fetch"));

function fixture(first: () => Promise<Response>) {
  const state = { answer: first, isSeen: true, isOpen: true, asked: 0, lost: 0, back: 0, losesConnection: true };
  const reach = watchReach({
    // Silence ends with the signal.
    fetcher: (_, init) => {
      state.asked++;
      const silence = new Promise<Response>((_resolve, reject) => init?.signal?.addEventListener("abort", () => reject(new TypeError("aborted"))));
      return Promise.race([state.answer(), silence]);
    },
    now: () => Date.now(),
    every: (time, act) => {
      const timer = setInterval(act, time);
      return () => clearInterval(timer);
    },
    timeout: (time) => {
      const aborts = new AbortController();
      setTimeout(() => aborts.abort(), time);
      return aborts.signal;
    },
    isSeen: () => state.isSeen,
    isOpen: () => state.isOpen,
    onLost: () => {
      state.lost++;
      if (state.losesConnection) state.isOpen = false;
    },
    onBack: () => {
      state.back++;
      state.isOpen = true;
    },
  });
  return { state, reach };
}

const silent = () => new Promise<Response>(() => undefined);
const wait = (time: number) => vi.advanceTimersByTimeAsync(time);
/** The page does nothing for so long, and then all that was due. */
const standStill = (time: number) => void vi.setSystemTime(Date.now() + time);

describe("the reach of a server", () => {
  it("is there while it answers, whatever it answers", async () => {
    const { state } = fixture(there);
    await wait(3 * kAsk);
    expect(state).toMatchObject({ asked: 3, lost: 0 });
  });

  it("is lost when two questions in a row fail, and told of each that follows while a connection is open", async () => {
    const { state } = fixture(refused);
    state.losesConnection = false;
    await wait(kAsk);
    expect(state.lost).toBe(0);
    await wait(2 * kAsk);
    expect(state).toMatchObject({ asked: 3, lost: 2 });
  });

  it("is lost by silence within some seconds, and back with the first answer", async () => {
    const { state } = fixture(silent);
    await wait(kPatience);
    expect(state.lost).toBe(0);
    await wait(kCertain - kPatience);
    expect(state).toMatchObject({ lost: 1, back: 0 });
    state.answer = there;
    await wait(kPatience + 2 * kAsk);
    expect(state).toMatchObject({ lost: 1, back: 1, isOpen: true });
    await wait(3 * kAsk);
    expect(state.back).toBe(1);
  });

  it("is there when a single question fails between two that are answered", async () => {
    const { state } = fixture(() => (state.asked % 2 === 0 ? refused() : there()));
    await wait(6 * kAsk);
    expect(state).toMatchObject({ asked: 6, lost: 0 });
  });

  it("is there while it sends something, though it answers no question", async () => {
    const { state, reach } = fixture(silent);
    for (let i = 0; i < 40; i++) {
      reach.heard();
      await wait(kAsk / 2);
    }
    expect(state.lost).toBe(0);
  });

  it("is there when it sends something during the second question", async () => {
    const { state, reach } = fixture(silent);
    await wait(2 * kPatience + kAsk / 2);
    reach.heard();
    await wait(kPatience - 100);
    expect(state).toMatchObject({ asked: 2, lost: 0 });
  });

  it("is not lost by questions during which nobody saw the page", async () => {
    const { state } = fixture(() => {
      state.isSeen = false;
      return refused();
    });
    for (let i = 0; i < 3; i++) {
      state.isSeen = true;
      await wait(kAsk);
    }
    expect(state).toMatchObject({ asked: 3, lost: 0 });
  });

  it("is not lost by questions during which the page was busy", async () => {
    const { state } = fixture(silent);
    for (let i = 0; i < 8; i++) {
      await wait(kPatience / 2);
      standStill(kPatience);
    }
    expect(state.lost).toBe(0);
    // Then it is not busy any more.
    await wait(kCertain + kPatience);
    expect(state.lost).toBe(1);
  });

  it("is not lost by one question before the device slept and one after it", async () => {
    const { state } = fixture(refused);
    await wait(kAsk);
    standStill(3_600_000);
    await wait(kAsk);
    expect(state).toMatchObject({ asked: 2, lost: 0 });
    state.answer = there;
    await wait(3 * kAsk);
    expect(state.lost).toBe(0);
  });

  it("has one question at a time", async () => {
    const { state } = fixture(silent);
    await wait(kAsk + kPatience - 1);
    expect(state.asked).toBe(1);
  });

  it("asks nothing while nobody sees the page, or its connection is lost by itself, or it has ended", async () => {
    const { state, reach } = fixture(refused);
    state.isSeen = false;
    await wait(3 * kAsk);
    state.isSeen = true;
    state.isOpen = false;
    await wait(3 * kAsk);
    state.isOpen = true;
    reach.end();
    await wait(3 * kAsk);
    expect(state).toMatchObject({ asked: 0, lost: 0 });
  });
});
