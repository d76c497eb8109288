// The stream's client: keeps one WebSocket open, tells the server which channels are wanted and what was seen of them last.
import { DecodeError } from "./json/decode";
import { streamMessage, type News, type StreamRequest } from "./messages/stream";

export type Connection = "connecting" | "open" | "lost";

export interface StreamHandlers {
  readonly onNews: (news: News) => void;
  readonly onConnection: (connection: Connection) => void;
  /** A message that does not have the agreed shape. */
  readonly onMalformed: (error: DecodeError) => void;
}

export interface Stream {
  subscribe(channel: string): void;
  unsubscribe(channel: string): void;
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

  const send = (request: StreamRequest) => {
    if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(request));
  };

  const receive = (text: string) => {
    try {
      const message = streamMessage(JSON.parse(text), "");
      if (!wanted.has(message.channel)) return;
      seen.set(message.channel, message.sequence);
      handlers.onNews(message.news);
    } catch (error) {
      if (!(error instanceof DecodeError)) throw error;
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
    close() {
      closed = true;
      socket?.close();
    },
  };
}
