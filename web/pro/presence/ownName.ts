// The name of the person at this browser: asked once, kept in local storage. Where that is refused, it lasts as long as the page.
import { guestName } from "../../shared/presence/names";
import { login } from "../client";
import { createStore, useSelected } from "../../page/store";

const kKey = "race.name";
const kGuest = "race.guest";

export interface OwnName {
  readonly name: string;
  /** The person has chosen it, or has seen it and left it. */
  readonly chosen: boolean;
}

function stored(): string | undefined {
  try {
    return localStorage.getItem(kKey) ?? undefined;
  } catch {
    return undefined;
  }
}

/** Of who has chosen no name: it stays in this browser, as the breakpoints that the server keeps are those of the name, and edits are undone by it. */
function guest(): string {
  const fresh = guestName(Math.random());
  try {
    const name = localStorage.getItem(kGuest) ?? fresh;
    localStorage.setItem(kGuest, name);
    return name;
  } catch {
    return fresh;
  }
}

function first(): OwnName {
  const known = stored();
  return known === undefined ? { name: guest(), chosen: false } : { name: known, chosen: true };
}

const own = createStore<OwnName, string>(first(), (_, name) => ({ name, chosen: true }));

/** Of an account, its name: the server takes no other. */
login.listen(() => {
  const name = login.get().me?.name;
  if (name !== undefined && name !== own.get().name) own.dispatch(name);
});

export const ownName = (): string => own.get().name;
export const useOwnName = (): OwnName => useSelected(own, (name) => name);
export const listenToOwnName = own.listen;

export function chooseName(name: string): void {
  own.dispatch(name);
  try {
    localStorage.setItem(kKey, name);
  } catch {
    // It is kept in memory.
  }
}
