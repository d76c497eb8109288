// Whether the server answers.
import { describe, expect, it } from "vitest";
import { kAsk, kPatience, watchReach } from "../shared/reach";

function fixture(answer: () => Promise<Response>, isSeen = () => true) {
  let tick = (): void => undefined;
  let [asked, lost] = [0, 0];
  watchReach({
    fetcher: () => {
      asked++;
      return answer();
    },
    every: (time, act) => {
      expect(time).toBe(kAsk);
      tick = act;
      return () => (tick = () => undefined);
    },
    timeout: (time) => {
      expect(time).toBe(kPatience);
      return new AbortController().signal;
    },
    isSeen,
    onLost: () => void lost++,
  });
  return {
    async tick() {
      tick();
      for (let i = 0; i < 5; i++) await Promise.resolve();
    },
    asked: () => asked,
    lost: () => lost,
  };
}

describe("the reach of a server", () => {
  it("is there while it answers, whatever it answers", async () => {
    const f = fixture(() => Promise.resolve(new Response("", { status: 503 })));
    for (let i = 0; i < 3; i++) await f.tick();
    expect([f.asked(), f.lost()]).toEqual([3, 0]);
  });

  it("is lost when two questions in a row fail, and told of each that follows", async () => {
    const f = fixture(() => Promise.reject(new TypeError("Failed to fetch")));
    await f.tick();
    expect(f.lost()).toBe(0);
    for (let i = 0; i < 2; i++) await f.tick();
    expect([f.asked(), f.lost()]).toEqual([3, 2]);
  });

  it("is there when a single one fails between two that are answered", async () => {
    let asked = 0;
    const f = fixture(() => (asked++ % 2 === 0 ? Promise.reject(new TypeError("Failed to fetch")) : Promise.resolve(new Response(""))));
    for (let i = 0; i < 6; i++) await f.tick();
    expect([f.asked(), f.lost()]).toEqual([6, 0]);
  });

  it("is not lost by a question during which nobody saw the page", async () => {
    let seen = true;
    const f = fixture(
      () => {
        seen = false;
        return Promise.reject(new TypeError("aborted"));
      },
      () => seen,
    );
    for (let i = 0; i < 3; i++) {
      seen = true;
      await f.tick();
    }
    expect([f.asked(), f.lost()]).toEqual([3, 0]);
  });

  it("has one question at a time", async () => {
    const f = fixture(() => new Promise(() => undefined));
    for (let i = 0; i < 3; i++) await f.tick();
    expect(f.asked()).toBe(1);
  });

  it("asks nothing while nobody sees the page", async () => {
    const f = fixture(() => Promise.reject(new TypeError("Failed to fetch")), () => false);
    await f.tick();
    expect([f.asked(), f.lost()]).toEqual([0, 0]);
  });
});
