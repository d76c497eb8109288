// Where a browser keeps the token of the account: for all pages of the server, until the login ends.

export interface TokenStore {
  readonly read: () => string | undefined;
  readonly write: (token: string | undefined) => void;
  /** From now on, `changed` is called when another page of the browser has written another token, or none. */
  readonly listen: (changed: () => void) => void;
}

const kKey = "race.token";

/** The part of a window that tells what other pages of the browser store. */
export interface StorageEvents {
  addEventListener(type: "storage", listener: (event: Pick<StorageEvent, "key" | "newValue">) => void): void;
}

/** In the storage of the browser; where that is refused, in memory, as long as the page is open. */
export function storedTokens(storage: () => Storage, events: StorageEvents): TokenStore {
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
    listen(changed) {
      events.addEventListener("storage", ({ key, newValue }) => {
        // Without a key: all of the storage was emptied.
        if (key !== kKey && key !== null) return;
        kept = newValue ?? undefined;
        changed();
      });
    },
  };
}
