// The WebSocket that the library uses: the browser's, or one that a program gives.

/** The part of a WebSocket that is used. */
export interface Socket {
  readonly readyState: number;
  onopen: (() => void) | null;
  onmessage: ((event: { readonly data: unknown }) => void) | null;
  onclose: ((event: { readonly code: number }) => void) | null;
  onerror: (() => void) | null;
  send(text: string): void;
  close(): void;
}

/** As `WebSocket` of browsers, of Node 22, and of the package `ws`; it also has the fields of Socket, which each types in its own way. */
export type SocketConstructor = new (address: string) => Pick<Socket, "readyState" | "send" | "close">;

/** `readyState` of a socket that is open. */
export const kOpen = 1;

/** RFC 6455, 7.4.1: the server ends, and says so. */
export const kGoingAway = 1001;

/** The one that is given, or that of the browser. Throws a TypeError if there is none. */
export function socketConstructor(given?: SocketConstructor): SocketConstructor {
  const known = given ?? (globalThis as { readonly WebSocket?: SocketConstructor }).WebSocket;
  if (known === undefined) throw new TypeError("there is no WebSocket here: give the client one, such as that of the package `ws`");
  return known;
}

/** A socket that connects to the address. */
export function openSocket(address: string, given?: SocketConstructor): Socket {
  const socket = new (socketConstructor(given))(address) as Socket;
  // Its end says all; `ws` throws what nobody hears.
  socket.onerror = () => undefined;
  return socket;
}
