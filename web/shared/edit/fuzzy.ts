// Finding commands by some of their letters.

/** How well `text` has the letters of `query` in their order, best highest; nothing: it has not. Words' beginnings and runs of letters count. */
function fuzzyScore(query: string, text: string): number | undefined {
  const [wanted, letters] = [query.toLowerCase().replace(/\s+/g, ""), text.toLowerCase()];
  let [score, from, last] = [0, 0, -2];
  for (const letter of wanted) {
    const begins = wordBeginning(letters, letter, from);
    const at = letters[last + 1] === letter ? last + 1 : begins >= 0 ? begins : letters.indexOf(letter, from);
    if (at < 0) return undefined;
    score += at === last + 1 ? 3 : at === begins ? 2 : 0;
    [last, from] = [at, at + 1];
  }
  return score - letters.length / 100;
}

/** Where a word begins with `letter`, at `from` or behind it. */
function wordBeginning(text: string, letter: string, from: number): number {
  for (let at = text.indexOf(letter, from); at >= 0; at = text.indexOf(letter, at + 1)) if (at === 0 || text[at - 1] === " ") return at;
  return -1;
}

/** Those that have the letters of the query, the best first; without a query all, as they are. */
export function fuzzyFilter<T>(query: string, items: readonly T[], textOf: (item: T) => string): readonly T[] {
  if (query.trim() === "") return items;
  const scored = items.map((item) => ({ item, score: fuzzyScore(query, textOf(item)) }));
  return scored.flatMap(({ item, score }) => (score === undefined ? [] : [{ item, score }])).sort((a, b) => b.score - a.score).map(({ item }) => item);
}
