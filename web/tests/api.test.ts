import { describe, expect, it } from "vitest";
import { createApi, RaceError } from "../shared/api";
import { applyEvent, emptySession } from "../shared/session/session";
import { readJson } from "./files";

const refusal = readJson(new URL("../../api/examples/problem.storage.json", import.meta.url));

describe("a command that the server refuses because it cannot store it", () => {
  it("fails with the status and the message of the server", async () => {
    const api = createApi(() => Promise.resolve(new Response(JSON.stringify(refusal), { status: 507 })));
    const error: unknown = await api.resume("1").catch((thrown: unknown) => thrown);
    expect(error).toBeInstanceOf(RaceError);
    expect(error).toMatchObject({ status: 507, message: "the run cannot be stored: no space left on the disk" });
  });
  it("leaves the connection as it is, and its message stays until it is dismissed", () => {
    const open = applyEvent(emptySession, { type: "connection", connection: "open" });
    const refused = applyEvent(open, { type: "problem", text: "no space left" });
    const later = applyEvent(refused, { type: "update", update: { type: "cores", cores: [] } });
    expect([later.connection, later.problem]).toEqual(["open", "no space left"]);
    expect(applyEvent(later, { type: "problem", text: undefined }).problem).toBeUndefined();
  });
});
