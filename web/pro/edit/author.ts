// The name under which this browser edits. The server keeps undo by it, so it is made once and kept.
const kKey = "race.author";

/** A name that nobody else has by chance. */
const newName = (): string => `Guest-${crypto.getRandomValues(new Uint16Array(1))[0]?.toString(36) ?? "0"}`;

/** Kept in local storage; where that is refused, it is another one for each page. */
export function author(): string {
  try {
    const known = localStorage.getItem(kKey);
    if (known !== null && known !== "") return known;
    const made = newName();
    localStorage.setItem(kKey, made);
    return made;
  } catch {
    return newName();
  }
}
