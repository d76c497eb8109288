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

  it("is lost when a question fails, and told of each time", async () => {
    const f = fixture(() => Promise.reject(new TypeError("Failed to fetch")));
    for (let i = 0; i < 3; i++) await f.tick();
    expect([f.asked(), f.lost()]).toEqual([3, 3]);
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
