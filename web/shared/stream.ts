// The stream's client: keeps one WebSocket open and subscribes the wanted channels from their last known message.
import type { StreamRequest } from "../generated/messages";
import { SchemaError } from "./messages/check";
import { readStreamMessage, type StreamUpdate } from "./messages/stream";

type DisplayRequest = Exclude<StreamRequest, { readonly type: "subscribe" | "unsubscribe" }>;

export type Connection = "connecting" | "open" | "lost";

export interface StreamHandlers {
  readonly onUpdate: (update: StreamUpdate) => void;
  readonly onConnection: (connection: Connection) => void;
  /** A message that breaks its schema. */
  readonly onMalformed: (error: SchemaError) => void;
}

export interface Stream {
  subscribe(channel: string): void;
  unsubscribe(channel: string): void;
  /** Makes this page a display, now and after each reconnect; its channel is subscribed with that. */
  announceDisplay(name: string, sound: boolean): void;
  /** Sends an action of the user on this display; false if the connection is lost. */
  sendAction(request: Exclude<DisplayRequest, { readonly type: "display" }>): boolean;
  close(): void;
}

/** Waits before the n-th attempt to connect again [ms]: 0.5 s, doubling, at most 8 s. */
export function reconnectDelay(attempt: number): number {
  return Math.min(8000, 500 * 2 ** attempt);
}

/** The requests when the socket opens: each wanted channel, with the number of its last known message. */
export function resubscriptions(wanted: ReadonlySet<string>, seen: ReadonlyMap<string, number>): readonly StreamRequest[] {
  return [...wanted].map((channel): StreamRequest => {
    const since = seen.get(channel);
    return since === undefined ? { type: "subscribe", channel } : { type: "subscribe", channel, since };
  });
}

export function openStream(url: string, handlers: StreamHandlers): Stream {
  const wanted = new Set<string>();
  const seen = new Map<string, number>();
  let socket: WebSocket | undefined;
  let attempt = 0;
  let closed = false;
  let display: Extract<DisplayRequest, { readonly type: "display" }> | undefined;

  const send = (request: StreamRequest): boolean => {
    if (socket?.readyState !== WebSocket.OPEN) return false;
    socket.send(JSON.stringify(request));
    return true;
  };

  /** A display also gets refusals of its own requests, which have no channel. */
  const isWanted = (channel: string): boolean => {
    if (wanted.has(channel)) return true;
    return display !== undefined && (channel === `display/${display.name}` || channel === "");
  };

  const receive = (text: string) => {
    try {
      const message = readStreamMessage(JSON.parse(text));
      if (!isWanted(message.channel)) return;
      seen.set(message.channel, message.sequence);
      handlers.onUpdate(message.update);
    } catch (error) {
      if (!(error instanceof SchemaError)) throw error;
      handlers.onMalformed(error);
    }
  };

  const connect = () => {
    handlers.onConnection("connecting");
    const opened = new WebSocket(url);
    socket = opened;
    opened.onopen = () => {
      attempt = 0;
      handlers.onConnection("open");
      if (display !== undefined) send(display);
      resubscriptions(wanted, seen).forEach(send);
    };
    opened.onmessage = (event: MessageEvent<unknown>) => receive(String(event.data));
    opened.onclose = () => {
      if (closed) return;
      handlers.onConnection("lost");
      setTimeout(connect, reconnectDelay(attempt++));
    };
  };
  connect();

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
    announceDisplay(name, sound) {
      display = { type: "display", name, sound };
      send(display);
    },
    sendAction: send,
    close() {
      closed = true;
      socket?.close();
    },
  };
}
