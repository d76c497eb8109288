import { describe, expect, it } from "vitest";
import { readExact, writeExact, type ExactJson } from "../../shared/edit/exact";
import { exactElements } from "../../shared/edit/exactElements";
import { exactLine, isInexact } from "../../shared/edit/exactLine";

describe("a constant as a text", () => {
  it.each(["1.0", "[0.5, 1.0]", '{"min": [-0, 1e3], "name": "a, b: c"}', "12345678901234567890", "null", '"x"'])("is as it was written: %s", (text) => expect(exactLine(readExact(text))).toBe(text));
  it("may be written in another way than JavaScript does if it has a whole number", () => {
    expect([1, [0.5, 2], { a: 0 }, 0.5, "1", null].map((value) => isInexact(value))).toEqual([true, true, true, false, false, false]);
  });
});

describe("the elements of a text", () => {
  it("are found by id, with their numbers", () => {
    const text = '{"rcm": 1, "library": [{"state": "L", "meta": {"id": "l"}}], "root": {"state": "R", "children": [{"state": "A", "parameters": [{"name": "p", "value": 1.0, "meta": {"id": "p"}}], "meta": {"id": "a"}}], "meta": {"id": "r"}}}';
    const found = exactElements(readExact(text));
    expect([...found.keys()].sort()).toEqual(["a", "l", "p", "r"]);
    expect(writeExact(found.get("p")?.["value"])).toBe("1.0");
  });
  it("are none of what is no document", () => expect(exactElements(readExact("[1.0]") satisfies ExactJson).size).toBe(0));
});
