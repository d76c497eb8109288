// A table changes without a copy, and stays as it was for whoever holds it.
import { describe, expect, it } from "vitest";
import { Table } from "../../shared/run/table";

const plain = (table: Table<number>) => Object.fromEntries(table.entries());

describe("Table", () => {
  it("has its entries with the changes, and is itself not changed", () => {
    const before = Table.of([["a", 1], ["b", 2]]);
    const after = before.with([["b", 3], ["c", 4], ["a", undefined]]);
    expect([plain(before), plain(after)]).toEqual([{ a: 1, b: 2 }, { b: 3, c: 4 }]);
    expect([after.get("a"), after.get("b"), after.get("c"), after.get("d")]).toEqual([undefined, 3, 4, undefined]);
  });

  it("is the same table without a change", () => {
    const table = Table.of([["a", 1]]);
    expect(table.with([])).toBe(table);
  });

  it("has an entry again that was removed", () => {
    expect(plain(Table.of([["a", 1]]).with([["a", undefined]]).with([["a", 2]]))).toEqual({ a: 2 });
  });

  it("equals a map that is given the same changes, over any number of them", () => {
    let table = Table.of<number>([]);
    const map = new Map<string, number>();
    for (let i = 0; i < 3000; i++) {
      const key = `k${(i * 7919) % 501}`;
      if (i % 5 === 0) map.delete(key);
      else map.set(key, i);
      table = table.with([[key, i % 5 === 0 ? undefined : i]]);
      if (i % 97 === 0) expect(plain(table)).toEqual(Object.fromEntries(map));
    }
    expect(plain(table)).toEqual(Object.fromEntries(map));
  });
});
