// One connection of services to the server: what is said on it.
import { failure, kConnection, kTimeout, RaceError } from "../errors.js";
import type { Hosted, Log } from "./hosted.js";
import { readMessage, type ServerMessage } from "./messages.js";
import { Outbox, type Sink } from "./outbox.js";

const kProtocolNumber = 1;
/** [s] for the connection, and for the server to welcome the services. */
export const kOpenTimeout = 5;

/** The part of a WebSocket that is used. */
export interface ServiceSocket extends Sink {
  onopen: (() => void) | null;
  onmessage: ((event: { readonly data: unknown }) => void) | null;
  onclose: (() => void) | null;
  onerror: ((event: { readonly message?: string }) => void) | null;
  close(): void;
}

export class Session {
  isWelcome = false;
  private readonly outbox: Outbox;
  /** [s] */
  private heartbeat = kOpenTimeout;
  private heard = performance.now();
  private isHalted = false;
  private problem = "the server has closed the connection";
  private timer: ReturnType<typeof setTimeout> | undefined;
  private end: (error: RaceError) => void = () => undefined;

  constructor(
    private readonly socket: ServiceSocket,
    private readonly hosted: readonly Hosted[],
    private readonly show: Log,
  ) {
    this.outbox = new Outbox(socket, () => this.end(failure(kConnection, "the server does not take what the services say")));
  }

  /** Until the connection ends. Rejects always: it was lost, or the server has refused the services (RaceError), or `signal` has ended it. */
  async run(signal: AbortSignal): Promise<never> {
    const ended = new Promise<never>((_, reject) => {
      this.end = reject;
    });
    const leave = () => this.end(failure(kConnection, "the services are offered no more"));
    signal.addEventListener("abort", leave, { once: true });
    if (signal.aborted) leave();
    this.listen();
    this.watch();
    try {
      return await ended;
    } finally {
      signal.removeEventListener("abort", leave);
      this.close();
      await Promise.all(this.hosted.map((each) => each.lost()));
    }
  }

  private listen(): void {
    const { socket } = this;
    const components = this.hosted.map((each) => each.component());
    socket.onopen = () => this.outbox.say(JSON.stringify({ type: "hello", protocol: kProtocolNumber, components, violations: true }));
    socket.onmessage = ({ data }) => this.receive(data);
    socket.onerror = ({ message }) => {
      if (message !== undefined && message !== "") this.problem = message;
    };
    socket.onclose = () => this.end(failure(kConnection, this.problem));
  }

  private close(): void {
    const { socket } = this;
    clearTimeout(this.timer);
    this.isHalted = true; // by `lost`
    this.outbox.close();
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.onerror = () => undefined; // `ws` throws what nobody hears
    socket.close();
  }

  private receive(data: unknown): void {
    this.heard = performance.now();
    this.isHalted = false;
    try {
      this.received(readMessage(data));
    } catch (error) {
      if (!(error instanceof RaceError)) throw error;
      this.end(error);
    }
  }

  private received(message: ServerMessage): void {
    if (message.type === "ping") this.outbox.say(JSON.stringify({ type: "pong", number: message.number }));
    else if (message.type === "refused") this.end(new RaceError(0, message.errors));
    else if (message.type === "welcome") this.welcome(message.heartbeat);
    else if (message.type !== "other") this.hosted.find(({ declaration }) => declaration.key === message.key)?.received(message);
  }

  private welcome(heartbeat: number): void {
    this.heartbeat = heartbeat;
    this.isWelcome = true;
    for (const each of this.hosted) {
      each.connected((message) => this.outbox.say(JSON.stringify(message)));
      this.show(`${each.declaration.key}: connected`);
    }
    this.watch();
  }

  /** Looks whether the server is silent; behind what has come meanwhile, which a program that was busy may not have read. */
  private watch(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      setImmediate(() => this.look());
      this.watch();
    }, (this.heartbeat / 2) * 1000);
  }

  private look(): void {
    const silent = (performance.now() - this.heard) / 1000;
    if (!this.isWelcome) {
      if (silent > kOpenTimeout) this.end(failure(kTimeout, "the server does not welcome the services"));
    } else if (silent > this.heartbeat && !this.isHalted) {
      this.isHalted = true;
      this.show("the server is silent: services halt");
      for (const each of this.hosted) void each.silent();
    }
  }
}
