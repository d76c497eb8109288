// A random source that gives the same numbers for the same seed.

export interface Random {
  /** A whole number below `n`. */
  readonly pick: (n: number) => number;
  readonly of: <T>(items: readonly T[]) => T;
  readonly chance: (p: number) => boolean;
}

/** mulberry32 */
export function randomOf(seed: number): Random {
  let state = seed >>> 0;
  const next = (): number => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
  const pick = (n: number) => Math.floor(next() * n);
  const of = <T>(items: readonly T[]): T => {
    const item = items[pick(items.length)];
    if (item === undefined) throw new Error("nothing to choose from");
    return item;
  };
  return { pick, of, chance: (p) => next() < p };
}

/** A whole number from the environment, printed so that a failure can be repeated. */
export function setting(name: string, standard: number): number {
  const value = Number(process.env[name] ?? standard);
  console.log(`${name}=${value}`);
  return value;
}
