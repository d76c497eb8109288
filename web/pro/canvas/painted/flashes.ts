// Ports that fired a moment ago: each flashes and fades.

/** How long a port flashes [ms]; as in canvas.css. */
const kFlash = 2400;
/** Of ports that fire at the same time, so many flash: more cannot be told apart. */
const kMost = 400;

export interface Flashes {
  readonly add: (addresses: readonly string[], now: number) => void;
  /** Address -> how strongly it flashes now, 1 to 0. */
  readonly at: (now: number) => ReadonlyMap<string, number>;
}

export function createFlashes(): Flashes {
  const begun = new Map<string, number>();
  const add = (addresses: readonly string[], now: number) => {
    for (const address of addresses) {
      begun.delete(address);
      begun.set(address, now);
    }
    for (const address of begun.keys()) {
      if (begun.size <= kMost) break;
      begun.delete(address);
    }
  };
  const at = (now: number) => {
    for (const [address, start] of begun) if (now - start > kFlash) begun.delete(address);
    return new Map([...begun].map(([address, start]) => [address, 1 - (now - start) / kFlash]));
  };
  return { add, at };
}
