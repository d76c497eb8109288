// The author of the edits of this page: the name of its person, with a tag that no other page has. The server keeps undo by the author, so
// two people of one name, and two pages of one person, each take back their own edits.
import { authorOf } from "../../shared/presence/names";
import { ownName } from "../presence/ownName";

const kKey = "race.page";

const newTag = (): string => (crypto.getRandomValues(new Uint32Array(1))[0] ?? 0).toString(36);

/** While a page is open its tag is not in the session storage: a page that is duplicated, with its storage, gets another one. */
function takeTag(): string | undefined {
  try {
    const tag = sessionStorage.getItem(kKey);
    sessionStorage.removeItem(kKey);
    return tag ?? undefined;
  } catch {
    return undefined;
  }
}

function keepTag(): void {
  try {
    sessionStorage.setItem(kKey, tag);
  } catch {
    // The page gets another one when it is loaded again.
  }
}

const tag = takeTag() ?? newTag();
addEventListener("pagehide", keepTag);
addEventListener("pageshow", ({ persisted }) => persisted && takeTag());

export const author = (): string => authorOf(ownName(), tag);
