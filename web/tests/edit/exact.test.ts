import { describe, expect, it } from "vitest";
import { NumberText, plain, readExact, writeExact } from "../../shared/edit/exact";

const kTexts = [
  "1.0", "1", "-0", "-0.0", "1e3", "9007199254740993", "0.1", "[1.0,1,{\"a\":2.50,\"b\":\"1.0\"}]", '{"1.0":[],"x":null,"y":true}', '"number 1.0"',
  '{"__proto__":1.0}', '"a\\"1.0\\\\"', "[ 1.0 , -2.0e+5 ]",
];

describe("exact numbers", () => {
  it.each(kTexts)("%s is written as it was read", (text) => expect(writeExact(readExact(text))).toBe(text.replace(/\s/g, text.startsWith("[ ") ? "" : "$&")));
  it.each(kTexts)("%s has the value that JavaScript reads", (text) => {
    expect(JSON.stringify(plain(readExact(text)))).toBe(JSON.stringify(JSON.parse(text)));
  });
  it("keeps numbers that JavaScript writes in the same way as numbers", () => {
    expect(readExact("[1,1.5,1.0]")).toEqual([1, 1.5, new NumberText("1.0")]);
  });
  it("takes no string for a number", () => {
    expect(readExact('["\\u006eumber 5", "number 1.0", 1.0]')).toEqual(["number 5", "number 1.0", new NumberText("1.0")]);
  });
  it("refuses what is no JSON", () => expect(() => readExact("1.")).toThrow(SyntaxError));
  it("leaves out fields that are undefined, as JSON.stringify does", () => expect(writeExact({ a: undefined, b: 1 })).toBe('{"b":1}'));
});
