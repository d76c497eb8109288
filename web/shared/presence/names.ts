// The name that a person chooses, and how it is shown.

/** As the server bounds it [characters]. */
export const kMaxName = 40;

/** What was typed as a name; nothing: it is none. */
export function nameFrom(typed: string): string | undefined {
  // eslint-disable-next-line no-control-regex -- the server refuses these
  const name = Array.from(typed.replace(/[\u0000-\u001f\u007f]+/g, " ").trim()).slice(0, kMaxName).join("").trim();
  return name === "" ? undefined : name;
}

/** Of who has chosen none. `random`: 0 to 1. */
export const guestName = (random: number): string => `Guest ${1 + Math.floor(random * 999)}`;

/** One or two letters for a face: of the first and the last word. */
export function initialsOf(name: string): string {
  const words = name.split(/[\s_.-]+/).filter((word) => word !== "");
  const first = (word: string | undefined) => Array.from(word ?? "")[0] ?? "";
  const [one, other] = [first(words[0]), words.length > 1 ? first(words.at(-1)) : ""];
  return `${one}${other}`.toLocaleUpperCase() || "?";
}

/** Names by which people can be told apart: the second of one name gets a number. In the order in which they came. */
export function distinctNames(people: readonly { readonly id: number; readonly name: string }[]): ReadonlyMap<number, string> {
  const seen = new Map<string, number>();
  return new Map(
    people.map(({ id, name }) => {
      const count = (seen.get(name) ?? 0) + 1;
      seen.set(name, count);
      return [id, count === 1 ? name : `${name} (${count})`];
    }),
  );
}

/** Between the name of a person and the tag of their page, in the author of an edit. */
const kTag = "~";

/** The author of edits that a page makes: the server keeps undo by it, so two people of one name have two. */
export const authorOf = (name: string, tag: string): string => `${name.replaceAll(kTag, "-")}${kTag}${tag}`;

/** The name in an author. */
export function nameOfAuthor(author: string): string {
  const end = author.lastIndexOf(kTag);
  return end > 0 ? author.slice(0, end) : author;
}
