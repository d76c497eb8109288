// Ids that nobody else makes. `crypto.randomUUID` is there over HTTPS and on this machine alone; this is everywhere.

function randomBytes(): Uint8Array {
  const bytes = new Uint8Array(16);
  const random = (globalThis as { readonly crypto?: Crypto }).crypto; // Node 18 has none by itself
  return random === undefined ? bytes.map(() => Math.floor(Math.random() * 256)) : random.getRandomValues(bytes);
}

/** 32 hexadecimal digits, each time others. */
export const newId = (): string => Array.from(randomBytes(), (byte) => byte.toString(16).padStart(2, "0")).join("");
