// A table of many entries of which a few change at a time: a change costs what it changes, and whoever holds a table sees it as it was.

/** So many changes are kept beside the entries before they are merged; merging costs as much as there are entries. */
const kBeside = 128;

export class Table<T> {
  private constructor(
    private readonly merged: ReadonlyMap<string, T>,
    /** Later entries; undefined: removed. */
    private readonly beside: ReadonlyMap<string, T | undefined>,
  ) {}

  static of<T>(entries: Iterable<readonly [string, T]>): Table<T> {
    return new Table<T>(new Map(entries), new Map());
  }

  get(key: string): T | undefined {
    return this.beside.has(key) ? this.beside.get(key) : this.merged.get(key);
  }

  *entries(): Generator<readonly [string, T]> {
    for (const [key, value] of this.merged) if (!this.beside.has(key)) yield [key, value];
    for (const [key, value] of this.beside) if (value !== undefined) yield [key, value];
  }

  /** The table with these entries in the place of those before; undefined removes one. */
  with(changes: readonly (readonly [string, T | undefined])[]): Table<T> {
    if (changes.length === 0) return this;
    const next = new Table(this.merged, new Map([...this.beside, ...changes]));
    return next.beside.size > kBeside ? Table.of(next.entries()) : next;
  }
}
