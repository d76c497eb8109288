// The name of the person at this browser: asked once, kept in local storage. Where that is refused, it lasts as long as the page.
import { guestName } from "../../shared/presence/names";
import { createStore, useSelected } from "../store";

const kKey = "race.name";

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

function first(): OwnName {
  const known = stored();
  return known === undefined ? { name: guestName(Math.random()), chosen: false } : { name: known, chosen: true };
}

const own = createStore<OwnName, string>(first(), (_, name) => ({ name, chosen: true }));

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
