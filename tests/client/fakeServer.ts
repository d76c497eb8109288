// A server that answers as a test says, over real sockets.
import { createHash } from "node:crypto";
import { createServer, type AddressInfo, type Server, type Socket } from "node:net";

/** What is said to a request; `close`: the connection is closed; `silent`: nothing is said. A function makes the answer of the request. */
export type Answer = string | Buffer | { readonly kind: "close" } | { readonly kind: "silent" } | ((request: string) => string | Buffer);

export const kClose: Answer = { kind: "close" };
export const kSilent: Answer = { kind: "silent" };

/** An answer with a JSON body. */
export function json(value: unknown, status = "200 OK"): string {
  const body = JSON.stringify(value);
  return `HTTP/1.1 ${status}\r\nContent-Type: application/json\r\nContent-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`;
}

/** Accepts a WebSocket (RFC 6455, 1.3). */
export function opensWebSocket(request: string): string {
  const [, key = ""] = /sec-websocket-key: (\S+)/i.exec(request) ?? [];
  const accepted = createHash("sha1").update(`${key}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`).digest("base64");
  return `HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${accepted}\r\n\r\n`;
}

/** A text message as a server sends it. Requires 126 bytes to 64 KiB. */
export function textFrame(text: string): Buffer {
  const payload = Buffer.from(text);
  return Buffer.concat([Buffer.from([0x81, 126, payload.length >> 8, payload.length & 0xff]), payload]);
}

export class FakeServer {
  /** First lines of the requests that have come. */
  readonly asked: string[] = [];
  readonly connections: Socket[] = [];

  private constructor(
    private readonly server: Server,
    readonly url: string,
  ) {}

  /** `answers`: to the requests in their order, whatever connection they come by; after these nothing is said. */
  static async start(...answers: readonly Answer[]): Promise<FakeServer> {
    const left = [...answers];
    const listener = createServer();
    await new Promise<void>((resolve) => listener.listen(0, "127.0.0.1", resolve));
    const fake = new FakeServer(listener, `http://127.0.0.1:${(listener.address() as AddressInfo).port}`);
    listener.on("connection", (socket) => {
      fake.connections.push(socket);
      socket.on("error", () => undefined).on("data", (data) => fake.answer(socket, data.toString("latin1"), left.shift() ?? kSilent));
    });
    return fake;
  }

  /** The methods of what was asked. */
  get methods(): readonly string[] {
    return this.asked.map((line) => line.split(" ")[0] ?? "");
  }

  close(): void {
    this.server.close();
    for (const socket of this.connections) socket.destroy();
  }

  private answer(socket: Socket, request: string, answer: Answer): void {
    this.asked.push(request.split("\r\n")[0] ?? "");
    const said = typeof answer === "function" ? answer(request) : answer;
    if (typeof said === "string" || Buffer.isBuffer(said)) {
      socket.write(said);
      if (said.includes("Connection: close")) socket.end();
    } else if (said.kind === "close") socket.destroy();
  }
}
