// A network between a page and the server that can be lost: from then on nothing is carried, and no connection ends.
import { createServer, connect, type Socket } from "node:net";
import { freePort } from "./fixture";

export interface Network {
  /** Of the server, over this network. */
  readonly url: string;
  readonly lose: () => void;
  /** What was under way arrives. */
  readonly restore: () => void;
  readonly close: () => void;
}

/** `url`: `http://HOST:PORT`. The server is told of its own port: it answers to no other. */
export async function openNetwork(url: string): Promise<Network> {
  const { hostname, port } = new URL(url);
  const own = await freePort();
  const sockets = new Set<Socket>();
  const [theirs, ours] = [`${hostname}:${own}`, `${hostname}:${port}`];
  let isLost = false;
  const server = createServer((from) => {
    const to = connect(Number(port), hostname);
    const carry = (source: Socket, target: Socket, change: (data: Buffer) => Buffer) => {
      sockets.add(source);
      if (isLost) source.pause();
      source.on("data", (data: Buffer) => target.write(change(data)));
      source.on("error", () => target.destroy());
      source.on("close", () => {
        sockets.delete(source);
        target.destroy();
      });
    };
    // Host and Origin stand in the texts of requests; frames of WebSockets are masked.
    carry(from, to, (data) => (data.includes(theirs) ? Buffer.from(data.toString("latin1").replaceAll(theirs, ours), "latin1") : data));
    carry(to, from, (data) => data);
  });
  await new Promise<void>((resolve) => server.listen(own, hostname, resolve));
  return {
    url: `http://${theirs}`,
    lose: () => {
      isLost = true;
      sockets.forEach((socket) => socket.pause());
    },
    restore: () => {
      isLost = false;
      sockets.forEach((socket) => socket.resume());
    },
    close: () => {
      sockets.forEach((socket) => socket.destroy());
      server.close();
    },
  };
}
