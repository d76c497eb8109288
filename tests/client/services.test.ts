// Conversations about services, and routes that have no method of their own.
import { calls, ServiceError, type Client } from "../../api/typescript/src/index";
import { refused } from "./asserting";
import { Server } from "./servers";

let server: Server;
let race: Client;
beforeAll(async () => {
  server = await Server.start();
  race = server.client();
});
afterAll(() => server.stop());

describe("services", () => {
  it("a call is answered with a result or an error", async () => {
    expect(await race.services.call("db", "add", ["greeting", { text: "hello" }])).toBe("greeting");
    expect(await race.services.call("db", "get", [], { key: "greeting" })).toEqual({ text: "hello" });
    const error = await refused(200, "not_found", race.services.call("db", "get", ["nothing"]));
    expect(error).toBeInstanceOf(ServiceError);
    expect(error).toMatchObject({ service: "db", operation: "get", error: { code: "not_found", message: error.message } });
    expect((await refused(200, "unavailable", race.services.call("db", "jump"))).path).toBe("db.jump");
    await refused(404, "not_found", race.services.call("nobody", "get"));
  });

  it("services say what they offer", async () => {
    const db = (await race.services.all()).find(({ key }) => key === "db");
    expect(db?.available).toBe(true);
    expect(db?.rsm.operations.map(({ name }) => name)).toContain("get");
  });

  it("any other route is a call", async () => {
    expect((await race.send(calls.getRules())).rules.map(({ rule }) => rule)).toContain("PTrigger");
    expect(await race.send(calls.getMetrics())).toContain("race_http_requests_total");
    expect((await race.stopCell()).stopped).toBeTruthy();
    expect((await race.resetStop()).stopped).toBeFalsy();
    expect((await race.health()).status).toBe("ok");
  });
});
