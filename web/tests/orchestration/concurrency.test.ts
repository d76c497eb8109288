// Calls of states beside each other, also of very many.
import { describe, expect, it } from "vitest";
import type { Node, State } from "../../shared/model/model";
import { concurrently } from "../../shared/orchestration/concurrency";

const state = (name: string): State => ({ kind: "state", name, parameters: [], results: [], variables: [], actions: [], children: [], ports: [] });

describe("concurrently", () => {
  it("gives each branch of a fork the calls of all others", () => {
    const children: readonly Node[] = [{ kind: "barrier", name: "All", to: ["A", "B", "C"] }, ...["A", "B", "C"].map(state)];
    const bits = new Map([["A", 1n], ["B", 2n], ["C", 4n]]);
    expect([...concurrently(children, (name) => bits.get(name) ?? 0n)]).toEqual([["A", 6n], ["B", 5n], ["C", 3n]]);
  });
  it("reads the branches of a fork a few times, however many there are", () => {
    const names = Array.from({ length: 1000 }, (_, i) => `S${i}`);
    const read = { count: 0 };
    const to = new Proxy(names, { get: (target, key, receiver) => (read.count++, Reflect.get(target, key, receiver) as unknown) });
    const found = concurrently([{ kind: "barrier", name: "All", to }, ...names.map(state)], (name) => 1n << BigInt(Number(name.slice(1)) % 40));
    expect(found.size).toBe(names.length);
    expect(read.count).toBeLessThan(10 * names.length);
  });
});
