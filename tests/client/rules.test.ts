// What the client library decides without a server: folding, gaps, bounds, errors.
import { calls, check, fold, RaceError, readStreamMessage, request, type Call, type messages, type StreamMessage } from "../../api/typescript/src/index";
import { failure, fetchFailure } from "../../api/typescript/src/errors";
import { sendTwice } from "../../api/typescript/src/sender";
import { CoreUpdates, type Update } from "../../api/typescript/src/stream/updates";
import rights from "../../api/rights.json";
import { core, delta, kNoChange, message, snapshot } from "./messages";
import { refused } from "./asserting";

/** WebSockets and Server-Sent Events: their answers have no end. */
const kEndless: readonly string[] = ["GET /api/v1/stream", "GET /api/v1/components", "GET /api/v1/control/hold", "GET /api/v1/cores/{id}/events"];

/** What the functions of routes take for parts of their paths. */
const namesOf = (make: { toString(): string }): readonly string[] => [...make.toString().matchAll(/segment\)?\((\w+)\)/g)].map(([, name = ""]) => name);

/** As the stream reads it. */
const read = (text: string): StreamMessage => readStreamMessage(JSON.parse(text));

function heard(updates: CoreUpdates): Update[] {
  const found: Update[] = [];
  for (let update = updates.pop(); update !== undefined; update = updates.pop()) found.push(update);
  return found;
}
const kinds = (updates: CoreUpdates): readonly string[] => heard(updates).map(({ kind }) => kind);

describe("folding", () => {
  it("a delta changes what it names and nothing else", () => {
    const before = { core: core(1), state: {
      active: ["Root", "Root/A"], ports: ["Root/A.done"], activated: { "Root/Both": ["Root/A.done"], "Root/Two": ["x"] },
      parameters: { Root: { a: 1, b: 2 }, "Root/A": { c: 3 } }, results: {}, variables: { Root: { v: 0 } } } };
    const kept = structuredClone(before);
    const after = fold(before, { ...kNoChange, core: core(2), active: { "Root/A": false, "Root/B": true, Root: true }, ports: { "Root/A.done": false },
      activated: { "Root/Both": [], "Root/Three": ["y"] }, parameters: { Root: { b: 5 } }, results: { Root: { r: null } },
      unset: { parameters: { Root: ["a"], "Root/A": ["c"] }, variables: { Root: ["v"] } } });
    expect(after).toEqual({ core: core(2), state: { active: ["Root", "Root/B"], ports: [], activated: { "Root/Two": ["x"], "Root/Three": ["y"] },
      parameters: { Root: { b: 5 } }, results: { Root: { r: null } }, variables: {} } });
    expect(before, "an update that was handed out stays as it is").toEqual(kept);
  });
});

describe("updates", () => {
  const begun = (): CoreUpdates => {
    const updates = new CoreUpdates(5);
    updates.opened();
    expect(updates.receive(read(snapshot(10)))).toBe(false);
    return updates;
  };

  it("deltas follow without a gap", () => {
    const updates = begun();
    updates.receive(read(delta(11, 1, "running", { active: { Root: true } })));
    expect(heard(updates).map(({ kind, state }) => [kind, state.state.active])).toEqual([["snapshot", []], ["delta", ["Root"]]]);
  });

  it("a gap asks for one new snapshot and takes nothing before it", () => {
    const updates = begun();
    expect(updates.receive(read(delta(12, 2)))).toBe(true);
    expect(updates.receive(read(delta(13, 3))), "it was asked for already").toBe(false);
    expect(updates.needsSnapshot).toBe(true);
    updates.receive(read(snapshot(14, 4)));
    updates.receive(read(delta(15, 5)));
    expect(heard(updates).map(({ kind, state }) => [kind, state.core.step])).toEqual([["snapshot", 0], ["snapshot", 4], ["delta", 5]]);
  });

  it("a new connection goes on behind the last message", () => {
    const updates = begun();
    updates.receive(read(delta(11, 1)));
    updates.lost("closed");
    updates.lost("another attempt has failed");
    updates.opened();
    updates.receive(read(delta(12, 2)));
    expect(kinds(updates)).toEqual(["snapshot", "delta", "disconnected", "connected", "delta"]);
  });

  it("a slow reader gets one snapshot for all and the news of the connection", () => {
    const updates = begun();
    updates.lost("closed");
    updates.opened();
    for (let number = 11; number < 1000; number++) updates.receive(read(delta(number, number)));
    const found = heard(updates);
    expect(found.length).toBeLessThanOrEqual(5);
    expect(found.slice(0, 3).map(({ kind }) => kind)).toEqual(["disconnected", "connected", "snapshot"]);
    expect(found.at(-1)?.state.core.step).toBe(999);
    const stand = found.slice(2).map((each) => (each.kind === "snapshot" ? Math.max(1, each.merged) : 1));
    expect(stand.reduce((sum, each) => sum + each), "the first snapshot and 989 deltas").toBe(990);
  });

  it("it is over with the run", () => {
    const updates = begun();
    expect(updates.isOver).toBe(false);
    updates.receive(read(delta(11, 1, "ended")));
    expect(updates.isOver).toBe(true);
  });

  it("an error of the channel is raised behind what came before", () => {
    const updates = begun();
    const gone = failure("not_found", "gone");
    updates.fail(gone);
    updates.fail(failure("connection", "later"));
    expect(updates.pop()?.kind).toBe("snapshot");
    expect(() => updates.pop()).toThrow(gone);
  });

  it("what is no message is an error and other channels are not its", () => {
    const updates = begun();
    expect(updates.receive(read(message("delta", 99, { core: core(1) }, "cores")))).toBe(false);
    expect(kinds(updates)).toEqual(["snapshot"]);
    const wrong = ["[]", "{}", "null", message("delta", 11, {}), message("snapshot", 11, { core: {}, state: {} }), message("delta", 11, [])];
    for (const text of wrong) expect(() => read(text), text).toThrow(/expected/);
  });
});

const answering = (status: number, body: BodyInit, headers: Record<string, string> = {}) => ({ origin: "", fetch: () => Promise.resolve(new Response(body, { status, headers })) });

describe("answers", () => {
  it("problem details are the error", async () => {
    const errors = [{ path: "Root", code: "first", message: "no child" }, { path: "", code: "json", message: "no JSON" }];
    const transport = answering(422, JSON.stringify({ errors, more_errors: true }), { "retry-after": "7" });
    const error = await refused(422, "first", request(transport, calls.getHealth()));
    expect(error).toMatchObject({ path: "Root", errors, moreErrors: true, retryAfter: 7, mayBeDone: false, message: "Root: no child; no JSON" });
  });

  it("what is of no server of race is said to be", async () => {
    for (const body of ["", "<html>", "[]", "{}", '{"errors": []}', '{"errors": [{}]}', '{"errors": 1}']) await refused(502, "protocol", request(answering(502, body), calls.getHealth()));
    for (const body of ["", "<html>", "[]", "null", "{}"]) await refused(0, "protocol", request(answering(200, body), calls.getHealth()));
    const large = answering(200, "{}", { "content-length": String(64 * 1024 * 1024 + 1) });
    await refused(0, "protocol", request(large, calls.getHealth()));
  });

  it("failures of sockets are told apart", () => {
    const failed = (code: string) => new TypeError("fetch failed", { cause: Object.assign(new Error("why"), { code }) });
    const told = (error: unknown) => {
      const { code, mayBeDone } = fetchFailure(error, "http://x");
      return [code, mayBeDone];
    };
    expect(told(new DOMException("late", "TimeoutError"))).toEqual(["timeout", true]);
    expect(["ECONNREFUSED", "ENOTFOUND"].map((code) => told(failed(code)))).toEqual(Array(2).fill(["connection", false]));
    expect(["ECONNRESET", "UND_ERR_SOCKET"].map((code) => told(failed(code)))).toEqual(Array(2).fill(["connection", true]));
    expect(["SELF_SIGNED_CERT_IN_CHAIN", "ERR_TLS_CERT_ALTNAME_INVALID"].map((code) => told(failed(code)))).toEqual(Array(2).fill(["certificate", false]));
    expect(told(failed("UND_ERR_CONNECT_TIMEOUT"))).toEqual(["timeout", false]);
    expect(told(failed("UND_ERR_HEADERS_TIMEOUT"))).toEqual(["timeout", true]);
    expect(told(failed("HPE_INVALID_CONSTANT"))).toEqual(["protocol", true]);
    expect(told(new TypeError("Failed to fetch")), "of a browser, which does not tell").toEqual(["connection", true]);
  });
});

describe("a request that is sent twice", () => {
  const call: Call<messages.Core> = calls.createCore({ document: "pick" });
  async function failed(...errors: RaceError[]): Promise<readonly [unknown, number]> {
    const left = [...errors];
    const send = (): Promise<never> => Promise.reject(left.shift() ?? new Error("sent too often"));
    const error: unknown = await sendTwice({ send }, call).catch((thrown: unknown) => thrown);
    return [error, left.length];
  }

  it("what was not sent is not sent again", async () => {
    const error = failure("connection", "refused", { isSent: false });
    expect(await failed(error, failure("timeout", "late"))).toEqual([error, 1]);
    expect(error.mayBeDone).toBe(false);
  });

  it("what was sent once may be done whatever becomes of the second time", async () => {
    for (const [code, isSent] of [["timeout", true], ["connection", false], ["certificate", false]] as const) {
      const last = failure(code, "last", { isSent });
      expect(await failed(failure("connection", "ended"), last)).toEqual([last, 0]);
      expect(last.mayBeDone).toBe(true);
    }
  });
});

describe("calls", () => {
  it("every route has a call with its method and path", () => {
    const routes = Object.keys(rights.routes).filter((route) => !kEndless.includes(route));
    const made = Object.entries(calls).flatMap(([name, make]) => {
      if (typeof make !== "function") return [];
      const words = namesOf(make).map((word) => `<${word}>`);
      const { method, path, answer } = (make as (...given: readonly unknown[]) => Call<unknown>)(...words, {}, {});
      if (answer !== "text") expect(() => check(answer, Symbol("none")), name).toThrow();
      return [`${method} ${path.replaceAll("%3C", "{").replaceAll("%3E", "}")}`];
    });
    expect([...new Set(made)].sort(), "one that can be deferred has two").toEqual(routes.sort());
  });
});
