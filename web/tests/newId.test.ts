// Ids of elements, edits and comments.
import { webcrypto } from "node:crypto";
import { describe, expect, it, vi } from "vitest";
import { newId } from "../shared/newId";

vi.stubGlobal("crypto", webcrypto); // Node 18 has none by itself

describe("a new id", () => {
  it("is of what the server takes, and never the same", () => {
    const ids = Array.from({ length: 1000 }, newId);
    expect(new Set(ids).size).toBe(1000);
    for (const id of ids) expect(id).toMatch(/^[0-9a-f]{32}$/);
  });
});
