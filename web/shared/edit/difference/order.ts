// Of the items of a list that stand in another order, the fewest that must have moved.

/** The numbers of a longest ascending sequence in `values`, which are all different. */
function longestAscending(values: readonly number[]): ReadonlySet<number> {
  /** For each length, the number of the item with which the sequence with the least end ends. */
  const ends: number[] = [];
  const before: (number | undefined)[] = [];
  for (const [i, value] of values.entries()) {
    let [low, high] = [0, ends.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((values[ends[middle] ?? 0] ?? 0) < value) low = middle + 1;
      else high = middle;
    }
    before[i] = ends[low - 1];
    ends[low] = i;
  }
  const found = new Set<number>();
  for (let at = ends.at(-1); at !== undefined; at = before[at]) found.add(at);
  return found;
}

/** The items of `after` that must be moved within it so that all that are in both lists stand as in `before`. No item is twice in a list. */
export function reordered(before: readonly string[], after: readonly string[]): readonly string[] {
  const places = new Map(before.map((item, i) => [item, i]));
  const common = after.filter((item) => places.has(item));
  const stay = longestAscending(common.map((item) => places.get(item) ?? 0));
  return common.filter((_, i) => !stay.has(i));
}
