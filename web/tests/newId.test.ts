// Ids of elements, edits and comments.
import { describe, expect, it } from "vitest";
import { newId } from "../shared/newId";

describe("a new id", () => {
  it("is of what the server takes, and never the same", () => {
    const ids = Array.from({ length: 1000 }, newId);
    expect(new Set(ids).size).toBe(1000);
    for (const id of ids) expect(id).toMatch(/^[0-9a-f]{32}$/);
  });
});
