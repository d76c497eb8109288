import { describe, expect, it } from "vitest";
import { literal } from "../../shared/model/literal";
import type { JsonValue } from "../../shared/json";

describe("literal", () => {
  it.each<[JsonValue, string]>([
    [null, "None"],
    [true, "True"],
    [false, "False"],
    [0.03, "0.03"],
    [-0, "-0.0"],
    [0.1234567890123, "0.1234567890123"],
    [-1e300, "-1e+300"],
    ["", "''"],
    ["it's 2\\3\n\tof a \"kind\"", "'it\\'s 2\\\\3\\n\\tof a \"kind\"'"],
    [[], "[]"],
    [[1, [null, "a"]], "[1, [None, 'a']]"],
    [{}, "{}"],
    [{ position: [0.4, 0, 1], "odd key": { held: true } }, "{'position': [0.4, 0, 1], 'odd key': {'held': True}}"],
  ])("writes %j as %s", (value, text) => expect(literal(value)).toBe(text));

  it.each<[JsonValue, JsonValue]>([
    [1, "1"],
    [true, "True"],
    [null, "None"],
    [["a, b"], ["a", "b"]],
    ["', '", ["", ""]],
    [{ a: 1, b: 2 }, { "a': 1, 'b": 2 }],
    ["\\n", "\n"],
    [0.3, 0.1 + 0.2],
  ])("keeps %j and %j apart", (one, other) => expect(literal(one)).not.toBe(literal(other)));
});
