// Ids that nobody else makes. `crypto.randomUUID` is there over HTTPS and on this machine alone; this is everywhere.

/** 32 hexadecimal digits, each time others. */
export const newId = (): string => Array.from(crypto.getRandomValues(new Uint8Array(16)), (byte) => byte.toString(16).padStart(2, "0")).join("");
