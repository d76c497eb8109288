// Who edits on this page: an account, or whoever is called so in this browser.
import { authorOf, guestName } from "../shared/presence/names";
import { pageTag } from "../pro/edit/pageTag";
import { me } from "./client";

/** The expert page keeps the name there, too. */
function storedName(): string {
  try {
    return localStorage.getItem("race.name") ?? localStorage.getItem("race.guest") ?? guestName(Math.random());
  } catch {
    return guestName(Math.random());
  }
}

const stored = storedName();

export const author = (): string => authorOf(me()?.name ?? stored, pageTag);
