// What is refused before it is sent.
import { calls, writeExact, type Client } from "../../api/typescript/src/index";
import { Server } from "./servers";

let server: Server;
let race: Client;
beforeAll(async () => {
  server = await Server.start();
  race = server.client();
});
afterAll(() => server.stop());

describe("requests", () => {
  it("what is no json is not sent", async () => {
    await expect(race.documents.put("nan", { rcm: NaN })).rejects.toThrow(TypeError);
    await expect(race.documents.put("object", { rcm: Symbol("none") })).rejects.toThrow(TypeError);
    for (const none of [[undefined], [1n], Infinity]) expect(() => writeExact(none)).toThrow(TypeError);
    await expect(race.send(calls.getDocument("ticking", { ifNoneMatch: '"1"\r\nX-Evil: 1' }))).rejects.toThrow(TypeError);
  });

  it("what is no part of a path is not sent", async () => {
    // A browser would take them for another path.
    for (const name of [".", ".."]) await expect(race.documents.delete(name)).rejects.toThrow(TypeError);
  });

  it("a token with other characters is not sent", () => {
    for (const token of ["", "a b", "a\r\nX-Evil: 1", "ä"]) expect(() => server.client({ token })).toThrow(TypeError);
  });
});
