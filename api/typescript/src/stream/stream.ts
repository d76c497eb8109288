// The stream's client: keeps one WebSocket open and subscribes the wanted channels from their last known message.
import { SchemaError } from "../check.js";
import { writeExact, type Exact } from "../exact.js";
import type { StreamRequest } from "../generated/messages.js";
import { readStreamMessage, type StreamMessage, type StreamUpdate } from "./messages.js";
import { kGoingAway, kOpen, openSocket, type Socket, type SocketConstructor } from "./socket.js";

type DisplayRequest = Extract<StreamRequest, { readonly type: "display" }>;
/** A request that the stream does not make by itself. */
export type OwnRequest = Exclude<StreamRequest, { readonly type: "subscribe" | "unsubscribe" | "display" | "gather" }>;

export type Connection = "connecting" | "open" | "lost";

export interface StreamHandlers {
  readonly onUpdate: (update: StreamUpdate, message: StreamMessage) => void;
  /** `ended`: it is lost because the server ends, as it says. */
  readonly onConnection: (connection: Connection, ended?: boolean) => void;
  /** A message that breaks its schema. */
  readonly onMalformed: (error: SchemaError) => void;
}

export interface Stream {
  /** From its snapshot on; of a channel that is subscribed, the snapshot comes once more. */
  subscribe(channel: string): void;
  unsubscribe(channel: string): void;
  /** Makes this page a display, at a place if one is named, now and after each reconnect; its channel is subscribed with that. */
  announceDisplay(name: string, sound: boolean, place?: string): void;
  /** Sends what a user does; false if the connection is lost. */
  send(request: Exact<OwnRequest>): boolean;
  /** Connects at once, if it waits for its next attempt. */
  retry(): void;
  /** Closes the connection, if there is one, and connects anew at once: the page is of another account. */
  reopen(): void;
  /** The server does not answer: the connection is lost, although its socket is open, and another one is tried. */
  abandon(): void;
  close(): void;
}

/** Waits before the n-th attempt to connect again [ms]: 0.5 s, doubling, at most 8 s. */
export function reconnectDelay(attempt: number): number {
  return Math.min(8000, 500 * 2 ** attempt);
}

/** The requests when the socket opens: each wanted channel, with the number of its last known message; what they say shall come together. */
export function resubscriptions(wanted: ReadonlySet<string>, seen: ReadonlyMap<string, number>): readonly StreamRequest[] {
  const subscriptions = [...wanted].map((channel): StreamRequest => {
    const since = seen.get(channel);
    return since === undefined ? { type: "subscribe", channel } : { type: "subscribe", channel, since };
  });
  return [{ type: "gather" }, ...subscriptions];
}

/** A connection that is not open after so long is given up: on a silent network, the next one is open sooner than this one [ms]. */
export const kConnect = 4000;

export interface StreamOptions {
  /** Nothing: that of the browser. */
  readonly webSocket?: SocketConstructor | undefined;
  /** Before the n-th attempt to connect again [ms]. */
  readonly delay?: (attempt: number) => number;
}

/** The address of the stream of the server that a page came from. */
export const streamUrl = ({ protocol, host }: Pick<Location, "protocol" | "host">): string => `${protocol === "https:" ? "wss" : "ws"}://${host}/api/v1/stream`;

/** `url` gives the address for each attempt to connect: of an account, one with a ticket of its own. */
export function openStream(url: () => string | Promise<string>, handlers: StreamHandlers, { webSocket, delay = reconnectDelay }: StreamOptions = {}): Stream {
  const wanted = new Set<string>();
  const seen = new Map<string, number>();
  let socket: Socket | undefined;
  let attempt = 0;
  let closed = false;
  /** The next attempt to connect does not wait. */
  let hurries = false;
  let again: ReturnType<typeof setTimeout> | undefined;
  /** Ends the attempt that goes on. */
  let limit: ReturnType<typeof setTimeout> | undefined;
  /** Of attempts: an address that comes late is for none that was given up. */
  let attempts = 0;
  let display: DisplayRequest | undefined;

  const send = (request: Exact<StreamRequest>): boolean => {
    if (socket?.readyState !== kOpen) return false;
    socket.send(writeExact(request));
    return true;
  };

  /** A display also gets refusals of its own requests, which have no channel. */
  const isWanted = (channel: string): boolean => {
    if (wanted.has(channel)) return true;
    return display !== undefined && (channel === `display/${display.name}` || channel === "");
  };

  const receive = (value: unknown) => {
    try {
      const message = readStreamMessage(value);
      if (!isWanted(message.channel)) return;
      if (message.sequence !== undefined) seen.set(message.channel, message.sequence);
      handlers.onUpdate(message.update, message);
    } catch (error) {
      if (!(error instanceof SchemaError)) throw error;
      handlers.onMalformed(error);
    }
  };

  const receiveText = (text: string) => {
    let messages: unknown;
    try {
      messages = JSON.parse(text);
    } catch {
      handlers.onMalformed(new SchemaError("", "JSON", text));
      return;
    }
    [messages].flat().forEach(receive);
  };

  /** Its user may close it when it is told something. */
  const isClosed = () => closed;

  const lose = (ended = false) => {
    if (closed) return;
    clearTimeout(limit);
    attempts++;
    handlers.onConnection("lost", ended);
    if (isClosed()) return;
    again = setTimeout(connect, hurries ? 0 : delay(attempt++));
    hurries = false;
  };

  const connect = () => {
    again = undefined;
    const mine = ++attempts;
    const isMine = () => mine === attempts && !closed;
    limit = setTimeout(giveUp, kConnect);
    handlers.onConnection("connecting");
    try {
      const at = url();
      if (typeof at === "string") connectTo(at);
      else at.then((given) => isMine() && connectTo(given), () => isMine() && lose());
    } catch {
      lose();
    }
  };

  /** Whatever its socket says later, it is of the past. */
  const giveUp = () => {
    const abandoned = socket;
    socket = undefined;
    abandoned?.close();
    lose();
  };

  const connectTo = (address: string) => {
    const opened = openSocket(address, webSocket);
    socket = opened;
    opened.onopen = () => {
      if (socket !== opened) return;
      attempt = 0;
      clearTimeout(limit);
      if (display !== undefined) send(display);
      resubscriptions(wanted, seen).forEach(send);
      handlers.onConnection("open");
    };
    opened.onmessage = (event) => {
      if (socket === opened) receiveText(String(event.data));
    };
    opened.onclose = ({ code }) => {
      if (socket === opened) lose(code === kGoingAway);
    };
  };
  connect();

  const retry = () => {
    if (again === undefined) return;
    clearTimeout(again);
    connect();
  };

  return {
    subscribe(channel) {
      wanted.add(channel);
      send({ type: "subscribe", channel });
    },
    unsubscribe(channel) {
      wanted.delete(channel);
      seen.delete(channel);
      send({ type: "unsubscribe", channel });
    },
    announceDisplay(name, sound, place) {
      display = { type: "display", name, sound, ...(place === undefined ? {} : { place }) };
      send(display);
    },
    send,
    retry,
    reopen() {
      if (again !== undefined) retry();
      else if (socket !== undefined && socket.readyState <= kOpen) {
        hurries = true;
        socket.close();
      }
    },
    abandon() {
      if (again === undefined && socket !== undefined) giveUp();
    },
    close() {
      closed = true;
      clearTimeout(again);
      clearTimeout(limit);
      socket?.close();
    },
  };
}
