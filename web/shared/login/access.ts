// Access: who uses the page. Its requests have the token of the account; when the server knows nobody by it, the page asks for a login.
import { getMe } from "../../../api/typescript/src/calls/me";
import { pair } from "../../../api/typescript/src/calls/pair";
import { createTicket, logIn, logOut } from "../../../api/typescript/src/calls/server";
import { isRefusal } from "../../../api/typescript/src/errors";
import { request, withToken } from "../../../api/typescript/src/request";
import type { LoginAnswer, Me, PairAnswer } from "../../generated/messages";
import type { TokenStore } from "./tokens";

export interface Access {
  /** Who it is; nothing: not known yet. */
  readonly me?: Me;
  /** The server wants a login: nothing else of it is answered. */
  readonly asked: boolean;
}

export interface AccessOptions {
  readonly fetcher: typeof fetch;
  readonly tokens: TokenStore;
  readonly onChange: (access: Access) => void;
  /** Another page of the browser has logged in, and this one is of that account now: its stream is to be opened anew. */
  readonly onOtherLogin: () => void;
}

/** Whatever the server says, it is there. */
function unlessRefused(error: unknown): undefined {
  if (!isRefusal(error)) throw error;
}

export function createAccess({ fetcher, tokens, onChange, onOtherLogin }: AccessOptions) {
  let access: Access = { asked: false };
  let nowKnown = (): void => undefined;
  const known = new Promise<void>((resolve) => (nowKnown = resolve));
  const change = (next: Partial<Access>): void => {
    access = { ...access, ...next };
    if (access.me?.role !== undefined) nowKnown();
    onChange(access);
  };

  const withOwnToken = withToken(fetcher, tokens.read);
  const authorized: typeof fetch = async (input, init) => {
    const answer = await withOwnToken(input, init);
    if (answer.status === 401) change({ asked: true });
    return answer;
  };
  const account = { origin: "", fetch: authorized };
  const anybody = { origin: "", fetch: fetcher };

  async function ask(): Promise<void> {
    const me = await request(account, getMe()).catch(unlessRefused);
    if (me === undefined) return;
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
      return tokens.read() === undefined ? url : `${url}?ticket=${encodeURIComponent((await request(account, createTicket())).ticket)}`;
    },
    /** Rejects with a RaceError. */
    async logIn(name: string, password: string): Promise<void> {
      const login: LoginAnswer = await request(anybody, logIn({ name, password }));
      tokens.write(login.token);
      const { name: known, role } = login.account;
      change({ me: { accounts: true, name: known, role }, asked: false });
    },
    /** With a code that somebody who is logged in has shown this device: once. Rejects with a RaceError. */
    async pair(code: string): Promise<PairAnswer> {
      const paired = await request(anybody, pair({ code }));
      // What the device was before, it is no more.
      if (tokens.read() !== undefined) await request(account, logOut()).catch(() => undefined);
      tokens.write(paired.token);
      await ask();
      return paired;
    },
    /** Ends the token, also if the server cannot be told. */
    async logOut(): Promise<void> {
      try {
        await request(account, logOut()).catch(unlessRefused);
      } finally {
        tokens.write(undefined);
        change({ me: { accounts: true }, asked: true });
      }
    },
  };
}

export type AccessControl = ReturnType<typeof createAccess>;
