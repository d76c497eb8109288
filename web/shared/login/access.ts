// Access: who uses the page. Its requests have the token of the account; when the server knows nobody by it, the page asks for a login.
import type { LoginAnswer, Me, PairAnswer, Ticket } from "../../generated/messages";
import * as schema from "../../generated/validators";
import { check } from "../messages/check";
import type { TokenStore } from "./tokens";

export interface Access {
  /** Who it is; nothing: not known yet. */
  readonly me?: Me;
  /** The server wants a login: nothing else of it is answered. */
  readonly asked: boolean;
}

export interface AccessOptions {
  /** "/api/v1" */
  readonly base: string;
  readonly fetcher: typeof fetch;
  readonly tokens: TokenStore;
  readonly onChange: (access: Access) => void;
  /** Another page of the browser has logged in, and this one is of that account now: its stream is to be opened anew. */
  readonly onOtherLogin: () => void;
}

/** The login was not accepted: why, and when to try again [s]. */
export class LoginError extends Error {
  constructor(
    message: string,
    readonly wait?: number,
    /** Of the error of the server. */
    readonly code?: string,
  ) {
    super(message);
    this.name = "LoginError";
  }
}

const kJson = { "content-type": "application/json" };

export function createAccess({ base, fetcher, tokens, onChange, onOtherLogin }: AccessOptions) {
  let access: Access = { asked: false };
  let nowKnown = (): void => undefined;
  const known = new Promise<void>((resolve) => (nowKnown = resolve));
  const change = (next: Partial<Access>): void => {
    access = { ...access, ...next };
    if (access.me?.role !== undefined) nowKnown();
    onChange(access);
  };

  const authorized: typeof fetch = async (input, init) => {
    const token = tokens.read();
    const headers = new Headers(init?.headers);
    if (token !== undefined) headers.set("authorization", `Bearer ${token}`);
    const answer = await fetcher(input, { ...init, headers });
    if (answer.status === 401) change({ asked: true });
    return answer;
  };

  async function ask(): Promise<void> {
    const answer = await authorized(`${base}/me`, { method: "GET" });
    if (!answer.ok) return;
    const me = check(schema.me, await answer.json());
    if (!me.accounts) tokens.write(undefined);
    change({ me, asked: me.role === undefined });
  }

  /** Another page of the browser has logged in or out: this one does so, too. */
  async function follow(): Promise<void> {
    if (tokens.read() === undefined && access.me?.accounts === true) {
      change({ me: { accounts: true }, asked: true });
      return;
    }
    await ask();
    if (!access.asked) onOtherLogin();
  }
  tokens.listen(() => void follow().catch(() => undefined)); // without a server, its stream asks again

  async function ticket(): Promise<Ticket> {
    const answer = await authorized(`${base}/tickets`, { method: "POST" });
    if (!answer.ok) throw new Error(`the server gives no ticket: status ${answer.status}`);
    return check(schema.ticket, await answer.json());
  }

  /** Asks to be let in, without a token. */
  async function enter(path: string, body: Readonly<Record<string, string>>): Promise<unknown> {
    const answer = await fetcher(`${base}/${path}`, { method: "POST", headers: kJson, body: JSON.stringify(body) });
    const data: unknown = await answer.json();
    if (answer.ok) return data;
    const [first] = check(schema.problem, data).errors;
    const wait = answer.headers.get("retry-after");
    throw new LoginError(first?.message ?? `status ${answer.status}`, wait === null ? undefined : Number(wait), first?.code);
  }

  return {
    get: (): Access => access,
    fetch: authorized,
    /** Asks the server who this is. */
    ask,
    /** Who it is, or that no server says so: what the page asks for before would be asked for by nobody. */
    known: (): Promise<void> => {
      ask().catch(nowKnown);
      return known;
    },
    /** The address of a stream for this account, once it is known whether the server wants a login. Rejects if it does, or there is no server. */
    async streamUrl(url: string): Promise<string> {
      if (access.me === undefined) await ask();
      if (access.asked) throw new Error("the server wants a login");
      return tokens.read() === undefined ? url : `${url}?ticket=${encodeURIComponent((await ticket()).ticket)}`;
    },
    /** Throws a LoginError. */
    async logIn(name: string, password: string): Promise<void> {
      const login: LoginAnswer = check(schema.loginAnswer, await enter("login", { name, password }));
      tokens.write(login.token);
      const { name: known, role } = login.account;
      change({ me: { accounts: true, name: known, role }, asked: false });
    },
    /** With a code that somebody who is logged in has shown this device: once. Throws a LoginError. */
    async pair(code: string): Promise<PairAnswer> {
      const paired = check(schema.pairAnswer, await enter("pair", { code }));
      // What the device was before, it is no more.
      if (tokens.read() !== undefined) await authorized(`${base}/logout`, { method: "POST" }).catch(() => undefined);
      tokens.write(paired.token);
      await ask();
      return paired;
    },
    /** Ends the token, also if the server cannot be told. */
    async logOut(): Promise<void> {
      try {
        await authorized(`${base}/logout`, { method: "POST" });
      } finally {
        tokens.write(undefined);
        change({ me: { accounts: true }, asked: true });
      }
    },
  };
}

export type AccessControl = ReturnType<typeof createAccess>;
