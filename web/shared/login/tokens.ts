// Where a browser keeps the token of the account: for all pages of the server, until the login ends.

export interface TokenStore {
  readonly read: () => string | undefined;
  readonly write: (token: string | undefined) => void;
}

const kKey = "race.token";

/** In the storage of the browser; where that is refused, in memory, as long as the page is open. */
export function storedTokens(storage: () => Storage): TokenStore {
  let kept: string | undefined;
  return {
    read() {
      try {
        return storage().getItem(kKey) ?? kept;
      } catch {
        return kept;
      }
    },
    write(token) {
      kept = token;
      try {
        if (token === undefined) storage().removeItem(kKey);
        else storage().setItem(kKey, token);
      } catch {
        // It is kept in memory.
      }
    },
  };
}
