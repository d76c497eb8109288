// WebSocket of Node 18, which has none: text messages, over TLS too.
import { randomBytes } from "node:crypto";
import * as http from "node:http";
import * as https from "node:https";
import type { Socket } from "node:net";

/** RFC 6455, 7.4.1: it ended without a close frame, as far as is told here. */
const kAbnormal = 1006;
const kText = 1;
const kClose = 8;
const kPing = 9;
const kPong = 10;

/** A frame as a client sends it: masked, and final. Requires less than 64 KiB. */
function frame(code: number, payload: Buffer): Buffer {
  const size = payload.length;
  const head = size < 126 ? Buffer.from([0x80 | code, 0x80 | size]) : Buffer.from([0x80 | code, 0x80 | 126, size >> 8, size & 0xff]);
  const mask = randomBytes(4);
  return Buffer.concat([head, mask, payload.map((byte, i) => byte ^ (mask[i % 4] ?? 0))]);
}

/** The first whole frame of `data`, which the server does not mask. */
function firstFrame(data: Buffer): { readonly code: number; readonly payload: Buffer; readonly rest: Buffer } | undefined {
  if (data.length < 2) return undefined;
  const short = (data[1] ?? 0) & 0x7f;
  const start = short === 126 ? 4 : short === 127 ? 10 : 2;
  if (data.length < start) return undefined;
  const size = short === 126 ? data.readUInt16BE(2) : short === 127 ? data.readUInt32BE(6) : short;
  if (data.length < start + size) return undefined;
  return { code: (data[0] ?? 0) & 0x0f, payload: data.subarray(start, start + size), rest: data.subarray(start + size) };
}

/** What openStream (api/typescript/src/stream) uses of a WebSocket. */
export class NodeSocket {
  static readonly OPEN = 1;
  static readonly all = new Set<NodeSocket>();
  readyState = 0;
  onopen: (() => void) | undefined;
  onmessage: ((event: { readonly data: string }) => void) | undefined;
  onclose: ((event: { readonly code: number }) => void) | undefined;
  private socket: Socket | undefined;
  private data: Buffer = Buffer.alloc(0);

  constructor(url: string) {
    const headers = { connection: "Upgrade", upgrade: "websocket", "sec-websocket-version": "13", "sec-websocket-key": randomBytes(16).toString("base64") };
    const request = (url.startsWith("wss:") ? https : http).get(url.replace(/^ws/, "http"), { headers });
    request.on("error", () => this.end()).on("response", () => this.end());
    request.on("upgrade", (_, socket: Socket, head: Buffer) => {
      this.socket = socket;
      this.readyState = NodeSocket.OPEN;
      NodeSocket.all.add(this);
      socket.on("data", (data: Buffer) => this.receive(data)).on("close", () => this.end()).on("error", () => this.end());
      this.onopen?.();
      if (head.length > 0) this.receive(head);
    });
  }

  send(text: string): void {
    this.socket?.write(frame(kText, Buffer.from(text)));
  }

  close(): void {
    this.socket?.end(frame(kClose, Buffer.alloc(0)));
  }

  /** Breaks the connection: what is under way is lost. */
  break(): void {
    this.socket?.resetAndDestroy();
    this.end();
  }

  protected deliver(data: string): void {
    this.onmessage?.({ data });
  }

  private receive(data: Buffer): void {
    this.data = Buffer.concat([this.data, data]);
    for (let next = firstFrame(this.data); next !== undefined && this.readyState === NodeSocket.OPEN; next = firstFrame(this.data)) {
      this.data = next.rest;
      if (next.code === kText) this.deliver(next.payload.toString("utf8"));
      if (next.code === kPing) this.socket?.write(frame(kPong, next.payload));
      if (next.code === kClose) this.close();
    }
  }

  private end(): void {
    if (this.readyState === 3) return;
    this.readyState = 3;
    NodeSocket.all.delete(this);
    this.onclose?.({ code: kAbnormal });
  }
}
