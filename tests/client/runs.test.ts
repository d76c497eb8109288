// Cores that are followed, and waited for.
import { type Client, type Update } from "../../api/typescript/src/index";
import { all, next, refused, sets, until } from "./asserting";
import { task, type Task } from "./models";
import { Server } from "./servers";

/** [s]; no test needs them. */
const kQuiet = 20;
const pause = (seconds: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, 1000 * seconds));

let server: Server;
let race: Client;
beforeAll(async () => {
  server = await Server.start();
  race = server.client();
});
afterAll(() => server.stop());

async function coreOf(document: Task): Promise<string> {
  await race.documents.put(document.name, document);
  return (await race.cores.create(document.name)).id;
}

const stepOf = ({ state }: Update): number => state.core.step;

describe("runs", () => {
  it("folded deltas are the state of a run at any time", async () => {
    const id = await coreOf(task("hurrying", { name: "folded" }));
    const updates = await race.cores.follow(id, { quiet: kQuiet });
    await race.cores.start(id);
    for (const step of [5, 40, 80]) {
      let update = await next(updates);
      while (stepOf(update) < step) update = await next(updates);
      await race.cores.pause(id);
      await until(race, id, ({ paused, micro }) => paused && micro === 0);
      const state = await race.cores.state(id);
      while (stepOf(update) < state.core.step) update = await next(updates);
      expect(sets(update.state)).toEqual(sets(state));
      expect(update.state.state.active).toContain("Root");
      await race.cores.resume(id);
    }
    expect((await race.cores.abort(id)).status).toBe("aborted");
    expect((await all(updates)).at(-1)?.state.core.status).toBe("aborted");
  });

  it("derivations come page by page", async () => {
    const id = await coreOf(task("hurrying", { name: "long" }));
    await race.cores.start(id);
    await until(race, id, ({ step }) => step > 230);
    await race.cores.abort(id);
    const last = (await race.cores.get(id)).step;
    const steps = await all(race.cores.derivations(id));
    expect(steps.map(({ step }) => step)).toEqual(Array.from({ length: last }, (_, i) => i + 1));
    expect((await all(race.cores.derivations(id, { first: 99, last: 102 }))).map(({ step }) => step)).toEqual([99, 100, 101, 102]);
    expect(await all(race.runs.derivations(id, { first: 200 }))).toEqual(steps.slice(199));
    await refused(404, "not_found", all(race.runs.derivations("987654")));
  });

  it("a wait that is too short says so and the run goes on", async () => {
    const id = await coreOf(task("hurrying", { name: "waited" }));
    await race.cores.start(id);
    const begun = Date.now();
    const error = await refused(0, "timeout", race.cores.wait(id, { timeout: 0.5 }));
    expect(Date.now() - begun).toBeLessThan(3000);
    expect(error.message).toBe(`core ${id} is not over after 0.5 s: its status is running`);
    const byDate = await refused(0, "timeout", race.cores.wait(id, { signal: AbortSignal.timeout(300) }));
    expect(byDate.message).toBe(`core ${id} is not over in time: its status is running`);
    const why = new Error("a person has left");
    const aborted = new AbortController();
    setTimeout(() => aborted.abort(why), 300);
    await expect(race.cores.wait(id, { signal: aborted.signal })).rejects.toBe(why);
    expect((await race.cores.abort(id)).status).toBe("aborted");
    expect((await race.cores.wait(id, { timeout: kQuiet })).status).toBe("aborted");
  });

  it("a slow reader loses steps but not the state or the connection", async () => {
    const id = await coreOf(task("hurrying", { name: "fast" }));
    const updates = await race.cores.follow(id, { quiet: kQuiet, capacity: 20 });
    expect((await next(updates)).kind).toBe("snapshot");
    await race.cores.start(id);
    await pause(2);
    await race.cores.abort(id);
    await pause(1);
    const heard = await all(updates);
    expect(heard.length).toBeLessThanOrEqual(21);
    expect(heard[0]).toMatchObject({ kind: "snapshot" });
    expect(heard[0]?.kind === "snapshot" ? heard[0].merged : 0).toBeGreaterThan(20);
    expect(heard.filter(({ kind }) => kind !== "delta" && kind !== "snapshot")).toEqual([]);
    const last = heard.at(-1)?.state;
    expect(last && sets(last)).toEqual(sets(await race.cores.state(id)));
  });

  it("a reader that leaves its loop ends the connection", async () => {
    const id = await coreOf(task("hurrying", { name: "left" }));
    const updates = await race.cores.follow(id);
    await race.cores.start(id);
    for await (const { kind } of updates) if (kind === "delta") break;
    const rest = await all(updates);
    expect(rest.length).toBeLessThan(1000);
    expect(await updates.next()).toEqual({ done: true, value: undefined });
    await race.cores.abort(id);
  });
});
