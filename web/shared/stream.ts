// The stream's client: keeps one WebSocket open, tells the server which channels are wanted and what was seen of them last.
import type { StreamRequest } from "../generated/messages";
import { SchemaError } from "./messages/check";
import { readStreamMessage, type News } from "./messages/stream";

type DisplayRequest = Exclude<StreamRequest, { readonly type: "subscribe" | "unsubscribe" }>;

export type Connection = "connecting" | "open" | "lost";

export interface StreamHandlers {
  readonly onNews: (news: News) => void;
  readonly onConnection: (connection: Connection) => void;
  /** A message that does not have the agreed shape. */
  readonly onMalformed: (error: SchemaError) => void;
}

export interface Stream {
  subscribe(channel: string): void;
  unsubscribe(channel: string): void;
  /** From now on, and whenever the connection is back, this page is a display; its channel comes with that. */
  announce(name: string, sound: boolean): void;
  /** Says what a person did on this display; false if the connection is lost. */
  say(request: Exclude<DisplayRequest, { readonly type: "display" }>): boolean;
  close(): void;
}

/** Waits before the n-th attempt to connect again [ms]: 0.5 s, doubling, at most 8 s. */
export function reconnectDelay(attempt: number): number {
  return Math.min(8000, 500 * 2 ** attempt);
}

/** What to say when the socket opens: every wanted channel, with the number of the last message that was seen of it. */
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

  /** A display also hears why a request of its own was refused, which is of no channel. */
  const concerns = (channel: string): boolean => {
    if (wanted.has(channel)) return true;
    return display !== undefined && (channel === `display/${display.name}` || channel === "");
  };

  const receive = (text: string) => {
    try {
      const message = readStreamMessage(JSON.parse(text));
      if (!concerns(message.channel)) return;
      seen.set(message.channel, message.sequence);
      handlers.onNews(message.news);
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
    announce(name, sound) {
      display = { type: "display", name, sound };
      send(display);
    },
    say: send,
    close() {
      closed = true;
      socket?.close();
    },
  };
}
