// Conversations with servers that do not answer, or not as they should.
import { createServer, type AddressInfo } from "node:net";
import { Client, type Call, type ClientOptions, type messages } from "../../api/typescript/src/index";
import control from "../../api/examples/control.free.json";
import { stopCell } from "../../api/typescript/src/calls/index";
import { NodeSocket } from "../browser/nodeSocket";
import { refused } from "./asserting";
import { FakeServer, json, kClose, kSilent, opensWebSocket, textFrame, type Answer } from "./fakeServer";
import { core, snapshot } from "./messages";

const kHealth = { status: "ok", version: "1", time: 1, cell: false };
const kHealthy = json(kHealth);
const kControl = json(control);
const kTicket = json({ ticket: `ticket_${"x".repeat(43)}` });
/** Something that changes something. */
const start: Call<messages.Control> = stopCell();

const served: FakeServer[] = [];
afterEach(() => served.splice(0).forEach((server) => server.close()));

async function serve(...answers: readonly Answer[]): Promise<FakeServer> {
  const server = await FakeServer.start(...answers);
  served.push(server);
  return server;
}
const clientOf = (url: string, options: ClientOptions = {}): Client => new Client(url, { timeout: 5, webSocket: NodeSocket, ...options });

describe("a server that does not answer as it should", () => {
  it("what does not answer is given up in time", async () => {
    const server = await serve("HTTP/1.1 200 OK\r\nContent-Length: 100\r\n\r\n{");
    await refused(0, "timeout", clientOf(server.url, { timeout: 0.3 }).health());
  });

  it("what speaks no http or ends is an error", async () => {
    const cut = "HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: 9\r\n\r\n{";
    for (const [answer, code] of [["SSH-2.0\r\n\r\n", "protocol"], [cut, "connection"]] as const) {
      const server = await serve(answer, answer, answer);
      const race = clientOf(server.url);
      await refused(0, code, race.health());
      await refused(0, code, race.cores.follow("1"));
    }
  });

  it("a request that changes something is sent once over a connection that ended", async () => {
    const server = await serve(kHealthy, kControl);
    const race = clientOf(server.url);
    expect(await race.health()).toEqual(kHealth);
    server.connections[0]?.destroy();
    await new Promise((resolve) => setTimeout(resolve, 100)); // until the client knows
    expect(await race.send(start), "over a new connection").toEqual(control);
    expect(server.methods).toEqual(["GET", "POST"]);
  });

  it("what may have been done is not sent again and what only reads is", async () => {
    const server = await serve(kHealthy, kClose, kHealthy, kClose, kControl);
    const race = clientOf(server.url);
    expect([await race.health(), await race.health()], "asked again over a new connection").toEqual([kHealth, kHealth]);
    expect((await refused(0, "connection", race.send(start))).mayBeDone).toBe(true);
    expect(server.methods).toEqual(["GET", "GET", "GET", "POST"]);
  });

  it("what was never sent is known not to be done", async () => {
    const gone = createServer();
    await new Promise<void>((resolve) => gone.listen(0, "127.0.0.1", resolve));
    const { port } = gone.address() as AddressInfo;
    await new Promise((resolve) => gone.close(resolve));
    const race = clientOf(`http://127.0.0.1:${port}`);
    for (const ask of [() => race.cores.start("1"), () => race.cores.follow("1")]) expect((await refused(0, "connection", ask())).mayBeDone).toBe(false);
    // Of a server that takes the connection and says nothing, `fetch` does not tell whether the request has reached it.
    const silent = await serve();
    expect((await refused(0, "timeout", clientOf(silent.url, { timeout: 0.3 }).cores.start("1"))).mayBeDone).toBe(true);
  });

  it("a wait ends in time whatever the stream does", async () => {
    const one = (request: string): Buffer => Buffer.concat([Buffer.from(opensWebSocket(request)), textFrame(snapshot(1))]);
    const running = json(core(1));
    for (const stream of [["HTTP/1.1 101 Switching"], [opensWebSocket], [one, kClose]] as const) {
      const server = await serve(running, kTicket, ...stream);
      const begun = Date.now();
      const error = await refused(0, "timeout", clientOf(server.url, { timeout: 3 }).cores.wait("1", { timeout: 0.5 }));
      expect(Date.now() - begun).toBeLessThan(2000);
      expect(error.message).toBe("core 1 is not over after 0.5 s: its status is running");
    }
  });

  it("a stop waits for no connection that is half dead and is sent again", async () => {
    const busy = json({}, "503 Service Unavailable");
    for (const [first, second] of [[kSilent, kClose], [kClose, busy], [busy, kSilent]] as const) {
      const server = await serve(kHealthy, first, second, kControl);
      const race = clientOf(server.url, { timeout: 0.3 });
      await race.health();
      const begun = Date.now();
      expect(await race.stopCell()).toEqual(control);
      expect(Date.now() - begun).toBeLessThan(2000);
      expect(server.methods).toEqual(["GET", "POST", "POST", "POST"]);
    }
  });

  it("a stop is given up at last and may be done", async () => {
    const wrong = json({}, "404 Not Found");
    const cases: readonly (readonly [readonly Answer[], number, number, string, boolean])[] = [
      [Array<Answer>(9).fill(kSilent), 3, 0, "timeout", true],
      [[kSilent, kClose, kSilent, kControl], 3, 0, "timeout", true],
      [[wrong, kControl], 1, 404, "protocol", false],
    ];
    for (const [answers, times, status, code, mayBeDone] of cases) {
      const server = await serve(...answers);
      const error = await refused(status, code, clientOf(server.url, { timeout: 0.3 }).stopCell());
      expect(error.mayBeDone).toBe(mayBeDone);
      expect(server.asked).toHaveLength(times);
    }
  });
});
