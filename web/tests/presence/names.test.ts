import { describe, expect, it } from "vitest";
import { authorOf, distinctNames, guestName, initialsOf, kMaxName, nameFrom, nameOfAuthor } from "../../shared/presence/names";

describe("nameFrom", () => {
  it.each([
    ["  Ada Lovelace ", "Ada Lovelace"],
    ["A\tB\nC", "A B C"],
    ["   ", undefined],
    ["", undefined],
    ["\u0007", undefined],
  ])("takes %j as %j", (typed, name) => expect(nameFrom(typed)).toBe(name));

  it("takes as many characters as the server does, and none in half", () => {
    expect(Array.from(nameFrom("😀".repeat(kMaxName + 5)) ?? "")).toHaveLength(kMaxName);
  });
});

describe("initialsOf", () => {
  it.each([
    ["Ada", "A"],
    ["ada lovelace", "AL"],
    ["Guest 12", "G1"],
    ["Ana María de Souza", "AS"],
    ["ßen", "SS"],
    ["😀 x", "😀X"],
    ["--", "?"],
  ])("of %j are %j", (name, initials) => expect(initialsOf(name)).toBe(initials));
});

describe("distinctNames", () => {
  it("numbers those of one name", () => {
    const all = [{ id: 4, name: "Ada" }, { id: 5, name: "Bob" }, { id: 9, name: "Ada" }, { id: 11, name: "Ada" }];
    expect([...distinctNames(all).entries()]).toEqual([[4, "Ada"], [5, "Bob"], [9, "Ada (2)"], [11, "Ada (3)"]]);
  });
});

describe("an author", () => {
  it("has the name of a person, and is another one for each page", () => {
    expect(authorOf("Ada", "k3")).not.toBe(authorOf("Ada", "k4"));
    expect(nameOfAuthor(authorOf("Ada", "k3"))).toBe("Ada");
    expect(nameOfAuthor(authorOf("A~b", "k3")), "a name does not look like a tag").toBe("A-b");
  });
  it("of another program is shown as it is", () => {
    expect(nameOfAuthor("Ann")).toBe("Ann");
    expect(nameOfAuthor("~x")).toBe("~x");
    expect(nameOfAuthor("")).toBe("");
  });
});

it("a guest has a number", () => {
  expect(guestName(0)).toBe("Guest 1");
  expect(guestName(0.9999)).toBe("Guest 999");
});
