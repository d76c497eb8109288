// Conversations with a server that goes away.
import { rmSync } from "node:fs";
import { all, next, refused, untilOver } from "./asserting";
import { task } from "./models";
import { newFolder, Server } from "./servers";

const data = newFolder();
const running: Server[] = [];
afterAll(async () => {
  await Promise.all(running.map((server) => server.stop()));
  rmSync(data, { recursive: true, force: true });
});

async function start(folder = newFolder(), port = 0): Promise<Server> {
  const server = await Server.start([], { data: folder, port });
  running.push(server);
  return server;
}

describe("a server that goes away", () => {
  it("a client that follows is told that the server was away and goes on", async () => {
    const server = await start(data);
    const race = server.client();
    await race.documents.put("ticking", task("ticking", { last: 8 }));
    const { id } = await race.cores.create("ticking");
    const updates = await race.cores.follow(id, { quiet: 20 });
    await race.cores.start(id);
    while (Number((await next(updates)).state.state.results["Root"]?.["n"] ?? 0) < 2);
    await server.kill();
    await new Promise((resolve) => setTimeout(resolve, 700));
    await start(data, server.port);
    const told: string[] = [];
    let update = await next(updates);
    for (; update.kind !== "snapshot"; update = await next(updates)) {
      if (update.kind !== "delta") told.push(update.kind);
      if (update.kind === "disconnected") expect(update.reason).toMatch(/closed|reached|reset/);
    }
    expect(told).toEqual(["disconnected", "connected"]);
    expect(update.state.core).toMatchObject({ status: "interrupted", interruption: { reason: "restart" } });
    await race.cores.resume(id);
    const last = (await all(updates)).at(-1)?.state;
    expect(last?.core).toMatchObject({ outcome: "done", results: { n: 8 } });
    expect(await untilOver(race, id)).toEqual(last?.core);
  });

  it("a server that does not come back ends it", async () => {
    const server = await start();
    const race = server.client();
    await race.documents.put("ticking", task("ticking"));
    const { id } = await race.cores.create("ticking");
    const updates = await race.cores.follow(id, { patience: 0.5 });
    expect((await next(updates)).kind).toBe("snapshot");
    await server.kill();
    expect((await next(updates)).kind).toBe("disconnected");
    await refused(0, "connection", updates.next());
    const error = await refused(0, "connection", race.health());
    expect(error.mayBeDone).toBe(false);
    expect(error.message).toContain(`${server.url} cannot be reached`);
    await refused(0, "connection", race.cores.follow(id));
  });
});
