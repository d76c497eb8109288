import { describe, expect, it } from "vitest";
import { kMostStarters, starters } from "../../shared/documents/starters";

const document = (name: string, more: { readonly doc?: string; readonly errors?: number } = {}) => ({ name, revision: 1, errors: 0, ...more });

describe("the documents to start with", () => {
  it("are those that say what they do, then the others that can be started, then drafts", () => {
    const all = [document("b"), document("draft", { errors: 2, doc: "a draft" }), document("pick", { doc: "picks" }), document("a")];
    expect(starters(all).map(({ name }) => name)).toEqual(["pick", "a", "b", "draft"]);
  });
  it("are few", () => {
    expect(starters(Array.from({ length: 40 }, (_, i) => document(`d${i}`)))).toHaveLength(kMostStarters);
  });
});
