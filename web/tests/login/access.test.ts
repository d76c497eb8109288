// Who uses a page: the token of an account, and the login that the server asks for.
import { describe, expect, it } from "vitest";
import { RaceError } from "../../shared/api";
import { createAccess, type Access } from "../../shared/login/access";
import { kRoles, mayUse, refusalOf } from "../../shared/login/roles";
import { storedTokens } from "../../shared/login/tokens";

interface Asked {
  readonly path: string;
  readonly method: string;
  readonly token: string | null;
}

const kToken = `race_${"x".repeat(43)}`;
const problem = (status: number, code: string) => ({ status, title: "refused", detail: "no", errors: [{ path: "", code, message: "no" }] });

/** A page whose server answers with `answers`, by path; and what it has asked. */
function page(answers: Readonly<Record<string, readonly [number, unknown, Record<string, string>?]>>, token?: string) {
  let kept = token;
  let changed = (): void => undefined;
  let logins = 0;
  const asked: Asked[] = [];
  const seen: Access[] = [];
  const fetcher: typeof fetch = (input, init) => {
    const path = (typeof input === "string" ? input : input instanceof URL ? input.href : input.url).replace("/api/v1", "");
    asked.push({ path, method: init?.method ?? "GET", token: new Headers(init?.headers).get("authorization") });
    const [status, body, headers] = answers[path] ?? [404, problem(404, "not_found")];
    return Promise.resolve(new Response(JSON.stringify(body), { status, headers: headers ?? {} }));
  };
  const access = createAccess({
    fetcher,
    tokens: { read: () => kept, write: (next) => void (kept = next), listen: (listener) => (changed = listener) },
    onChange: (next) => seen.push(next),
    onOtherLogin: () => ++logins,
  });
  /** Another page of the browser stores this token, or none. */
  const store = async (next: string | undefined) => {
    kept = next;
    changed();
    await new Promise((resolve) => setTimeout(resolve));
  };
  return { access, asked, seen, kept: () => kept, store, logins: () => logins };
}

describe("a page of a server without accounts", () => {
  it("asks for nothing, and drops the token of a server that was", async () => {
    const { access, kept } = page({ "/me": [200, { accounts: false, role: "admin" }] }, kToken);
    await access.ask();
    expect(access.get()).toEqual({ me: { accounts: false, role: "admin" }, asked: false });
    expect(kept()).toBeUndefined();
    expect(await access.streamUrl("ws://here/stream")).toBe("ws://here/stream");
  });
});

describe("a page of a server with accounts", () => {
  const login = { token: kToken, expires: 1, account: { name: "ada", role: "developer", created: 1 } };

  it("asks for a login when nobody is known, and then for nothing else", async () => {
    const { access, asked } = page({ "/me": [200, { accounts: true }] });
    await expect(access.streamUrl("ws://here/stream")).rejects.toThrow("login");
    expect(access.get().asked).toBe(true);
    await expect(access.streamUrl("ws://here/stream")).rejects.toThrow("login");
    expect(asked.map(({ path }) => path)).toEqual(["/me"]);
  });

  it("sends its token with each request once it has one", async () => {
    const { access, asked, kept } = page({ "/login": [200, login], "/cores": [200, { cores: [] }] });
    await access.logIn("ada", "correct horse");
    expect(kept()).toBe(kToken);
    expect(access.get()).toEqual({ me: { accounts: true, name: "ada", role: "developer" }, asked: false });
    await access.fetch("/api/v1/cores", { method: "GET" });
    expect(asked.map(({ token }) => token)).toEqual([null, `Bearer ${kToken}`]);
  });

  it("opens its stream with a ticket, never with the token", async () => {
    const { access } = page({ "/me": [200, { accounts: true, name: "ada", role: "developer" }], "/tickets": [200, { ticket: `ticket_${"y".repeat(43)}` }] }, kToken);
    expect(await access.streamUrl("ws://here/stream")).toBe(`ws://here/stream?ticket=ticket_${"y".repeat(43)}`);
  });

  it("asks for a login when its token is good no more", async () => {
    const { access } = page({ "/me": [200, { accounts: true, name: "ada", role: "developer" }], "/tickets": [401, problem(401, "login")] }, kToken);
    await expect(access.streamUrl("ws://here/stream")).rejects.toMatchObject({ status: 401 });
    expect(access.get().asked).toBe(true);
  });

  it("says why a login is refused, and how long to wait", async () => {
    const { access, kept } = page({ "/login": [429, problem(429, "attempts"), { "retry-after": "6" }] });
    const refused = access.logIn("ada", "guess number");
    await expect(refused).rejects.toThrow(RaceError);
    await expect(refused).rejects.toMatchObject({ retryAfter: 6 });
    expect(kept()).toBeUndefined();
  });

  it("forgets its token with a logout, also without a server", async () => {
    const { access, asked, kept } = page({ "/logout": [500, problem(500, "internal")] }, kToken);
    await access.logOut();
    expect(asked).toEqual([{ path: "/logout", method: "POST", token: `Bearer ${kToken}` }]);
    expect(kept()).toBeUndefined();
    expect(access.get().asked).toBe(true);
  });
});

describe("several pages of one browser", () => {
  const ada = { accounts: true, name: "ada", role: "admin" };

  it("log out together, also without a server", async () => {
    const { access, store, asked, logins } = page({ "/me": [200, ada] }, kToken);
    await access.ask();
    await store(undefined);
    expect(access.get()).toEqual({ me: { accounts: true }, asked: true });
    expect(asked).toHaveLength(1);
    expect(logins()).toBe(0);
  });

  it("take the account of a new login, and open their streams anew", async () => {
    const { access, store, asked, logins } = page({ "/me": [200, ada] });
    await store(kToken);
    expect(access.get()).toEqual({ me: ada, asked: false });
    expect(asked).toEqual([{ path: "/me", method: "GET", token: `Bearer ${kToken}` }]);
    expect(logins()).toBe(1);
  });

  it("stay as they are where the server has no accounts, or does not answer", async () => {
    const without = page({ "/me": [200, { accounts: false, role: "admin" }] });
    await without.access.ask();
    await without.store(undefined);
    expect(without.access.get().asked).toBe(false);
    const lost = page({ "/me": [503, problem(503, "overload")] }, kToken);
    await lost.store(undefined);
    expect(lost.access.get()).toEqual({ asked: false });
  });
});

describe("a role", () => {
  it("may do what those before it may", () => {
    const may = (right: string) => [undefined, ...kRoles].map((role) => (mayUse(role, right) ? 1 : 0)).join("");
    expect(["anyone", ...kRoles, "process", "nonsense"].map(may)).toEqual(["11111", "01111", "00111", "00011", "00001", "00000", "00000"]);
  });

  it("is told what a route needs", () => {
    expect(refusalOf({ accounts: true, name: "eve", role: "observer" }, "PUT /api/v1/documents/{name}")).toBe("this needs the role developer, and your account has the role observer");
    expect(refusalOf({ accounts: true, name: "eve", role: "admin" }, "PUT /api/v1/documents/{name}")).toBeUndefined();
    expect(refusalOf(undefined, "PUT /api/v1/documents/{name}"), "not known yet").toBeUndefined();
  });
});

const noEvents = { addEventListener: () => undefined };

describe("a token", () => {
  it("is kept in memory where the browser keeps nothing", () => {
    const tokens = storedTokens(() => {
      throw new Error("refused");
    }, noEvents);
    tokens.write(kToken);
    expect(tokens.read()).toBe(kToken);
    tokens.write(undefined);
    expect(tokens.read()).toBeUndefined();
  });

  it("is told when another page stores one, and is forgotten when that empties the storage", () => {
    const items = new Map<string, string>();
    const storage = { getItem: (key: string) => items.get(key) ?? null, setItem: (key: string, value: string) => void items.set(key, value), removeItem: (key: string) => void items.delete(key) };
    let tell: (event: { readonly key: string | null; readonly newValue: string | null }) => void = () => undefined;
    const tokens = storedTokens(() => storage as unknown as Storage, { addEventListener: (_, listener) => (tell = listener) });
    const seen: (string | undefined)[] = [];
    tokens.listen(() => seen.push(tokens.read()));
    tokens.write(kToken);
    expect(seen, "not of what this page writes").toEqual([]);
    tell({ key: "race.name", newValue: "eve" });
    expect(seen, "not of anything else").toEqual([]);
    items.set("race.token", "another");
    tell({ key: "race.token", newValue: "another" });
    items.clear();
    tell({ key: null, newValue: null });
    expect(seen).toEqual(["another", undefined]);
  });
});
