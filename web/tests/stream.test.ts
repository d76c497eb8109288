// The connection of a page over a network that says nothing.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { kConnect, openStream, reconnectDelay } from "../shared/stream";

/** The part of a WebSocket that the stream uses; it opens when the test says so. */
class TestSocket {
  static readonly OPEN = 1;
  static opened: TestSocket[] = [];
  readyState = 0;
  onopen = (): void => undefined;
  onclose: ((event: { readonly code: number }) => void) | undefined;
  onmessage: ((event: { readonly data: string }) => void) | undefined;
  readonly sent: string[] = [];
  constructor(readonly address: string) {
    TestSocket.opened.push(this);
  }
  open(): void {
    this.readyState = TestSocket.OPEN;
    this.onopen();
  }
  send(text: string): void {
    this.sent.push(text);
  }
  /** Nobody answers that, either. */
  close(): void {
    this.readyState = 2;
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("WebSocket", TestSocket);
  TestSocket.opened = [];
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

function fixture(url: () => string | Promise<string> = () => "ws://cell/stream") {
  const told: string[] = [];
  const stream = openStream(url, { onConnection: (connection) => told.push(connection), onUpdate: () => undefined, onMalformed: () => undefined });
  return { stream, told };
}

describe("the connection of a page", () => {
  it("gives up an attempt that nobody answers, and makes another one", () => {
    const { told } = fixture();
    vi.advanceTimersByTime(kConnect);
    expect(told).toEqual(["connecting", "lost"]);
    vi.advanceTimersByTime(reconnectDelay(0));
    expect(TestSocket.opened.length).toBe(2);
    // Too late: it is of the past.
    TestSocket.opened[0]?.open();
    expect(told).toEqual(["connecting", "lost", "connecting"]);
    TestSocket.opened[1]?.open();
    expect(TestSocket.opened.map(({ sent }) => sent)).toEqual([[], ['{"type":"gather"}']]);
    vi.advanceTimersByTime(2 * kConnect);
    expect(told).toEqual(["connecting", "lost", "connecting", "open"]);
  });

  it("gives up an attempt whose address never comes, and takes none that comes late", async () => {
    const addresses: ((address: string) => void)[] = [];
    const { told } = fixture(() => new Promise((resolve) => addresses.push(resolve)));
    vi.advanceTimersByTime(kConnect + reconnectDelay(0));
    expect(told).toEqual(["connecting", "lost", "connecting"]);
    addresses[0]?.("ws://cell/first");
    addresses[1]?.("ws://cell/second");
    await vi.advanceTimersByTimeAsync(0);
    expect(TestSocket.opened.map(({ address }) => address)).toEqual(["ws://cell/second"]);
  });

  it("is lost when it is abandoned, and connects at once when that is asked for", () => {
    const { stream, told } = fixture();
    TestSocket.opened[0]?.open();
    stream.abandon();
    stream.abandon();
    expect(told).toEqual(["connecting", "open", "lost"]);
    stream.retry();
    stream.retry();
    expect(TestSocket.opened.length).toBe(2);
  });

  it("makes no more attempts once it is closed", () => {
    const { stream } = fixture();
    vi.advanceTimersByTime(kConnect);
    stream.close();
    vi.advanceTimersByTime(60_000);
    expect(TestSocket.opened.length).toBe(1);
  });
});
