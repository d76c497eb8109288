// What is said to the server: in order, and bounded.

/** Messages that the server has not taken. */
export const kMaxOut = 10_000;
/** [bytes] that the socket holds; what comes further waits here. */
const kBuffered = 64 * 1024;
/** [ms] between looks at that. */
const kLook = 10;

/** Of a WebSocket. */
export interface Sink {
  /** [bytes] that it holds. */
  readonly bufferedAmount?: number;
  send(text: string): void;
}

export class Outbox {
  private readonly waiting: string[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** `onFull`: a server that takes nothing is lost. */
  constructor(
    private readonly sink: Sink,
    private readonly onFull: () => void,
  ) {}

  say(text: string): void {
    if (this.waiting.length >= kMaxOut) {
      this.onFull();
      return;
    }
    this.waiting.push(text);
    this.flush();
  }

  /** Nothing more is sent. */
  close(): void {
    clearTimeout(this.timer);
    this.waiting.length = 0;
  }

  private flush(): void {
    clearTimeout(this.timer);
    for (let next = this.waiting[0]; next !== undefined && (this.sink.bufferedAmount ?? 0) < kBuffered; next = this.waiting[0]) {
      this.waiting.shift();
      this.sink.send(next);
    }
    if (this.waiting.length > 0) this.timer = setTimeout(() => this.flush(), kLook);
  }
}
