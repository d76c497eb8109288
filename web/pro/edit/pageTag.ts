// The tag of this page, which no other page has: it stays when the page is loaded again.
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
    sessionStorage.setItem(kKey, pageTag);
  } catch {
    // The page gets another one when it is loaded again.
  }
}

export const pageTag = takeTag() ?? newTag();
addEventListener("pagehide", keepTag);
addEventListener("pageshow", ({ persisted }) => persisted && takeTag());
