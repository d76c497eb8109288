// A network that is gone: a core is followed over a connection that says nothing.
import { openFollowing } from "../../api/typescript/src/stream/following";
import { failure } from "../../api/typescript/src/errors";
import { snapshot } from "./messages";

/** A socket that opens at once, sends one snapshot, and then nothing. */
class QuietSocket {
  static made = 0;
  readyState = 1;
  onopen: (() => void) | null = null;
  onmessage: ((event: { readonly data: string }) => void) | null = null;
  constructor() {
    QuietSocket.made++;
    queueMicrotask(() => this.onopen?.());
  }
  send(text: string): void {
    if (text.includes('"subscribe"') && QuietSocket.made === 1) this.onmessage?.({ data: snapshot(1) });
  }
  close(): void {
    this.readyState = 3;
  }
}

describe("a network that is gone", () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it("a server that falls silent is lost", async () => {
    let asked = 0;
    const ask = () => {
      asked++;
      return Promise.reject(failure("timeout", "no answer"));
    };
    const server = { where: "http://x", timeout: 5, streamAddress: () => Promise.resolve("ws://x"), ask, webSocket: QuietSocket };
    const updates = await openFollowing(server, "1", { patience: 10 });
    expect((await updates.next()).value).toMatchObject({ kind: "snapshot" });
    await vi.advanceTimersByTimeAsync(15_000);
    expect(asked, "not before it was silent for 20 s").toBe(0);
    await vi.advanceTimersByTimeAsync(10_000);
    expect(asked).toBe(1);
    expect((await updates.next()).value).toMatchObject({ kind: "disconnected" });
    expect(QuietSocket.made).toBe(2);
    updates.close();
    expect(vi.getTimerCount(), "nothing goes on").toBe(0);
  });
});
