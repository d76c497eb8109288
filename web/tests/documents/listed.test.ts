import { describe, expect, it } from "vitest";
import { matching, namesOf } from "../../shared/documents/listed";

const documents = [
  { name: "pick", revision: 1, errors: 0, doc: "Picks a part whose pose is known." },
  { name: "place", revision: 4, errors: 2 },
];

describe("the search in the documents", () => {
  it("finds all words in name or description, in any case", () => {
    const found = (query: string) => [...namesOf(matching(documents, query))];
    expect(found("")).toEqual(["pick", "place"]);
    expect(found("P")).toEqual(["pick", "place"]);
    expect(found(" pick POSE ")).toEqual(["pick"]);
    expect(found("place pose")).toEqual([]);
  });
});
