import { describe, expect, it } from "vitest";
import { array, DecodeError, json, number, object, oneOf, present, string } from "../../shared/json/decode";

const point = object((f) => present<{ x: number; name?: string }>({ x: f.need("x", number), name: f.maybe("name", string) }));

describe("decode", () => {
  it("names the place of the first mismatch", () => {
    expect(() => array(point)([{ x: 1 }, { x: "2" }], "")).toThrow(new DecodeError("/1/x", "number", "2"));
  });
  it("tells a missing field from a wrong one", () => {
    expect(() => point({}, "")).toThrow("/x: expected number, got undefined");
    expect(() => point(null, "")).toThrow("/: expected object, got null");
  });
  it("leaves optional fields out instead of setting them to undefined", () => {
    expect(Object.keys(point({ x: 1 }, ""))).toEqual(["x"]);
  });
  it("accepts only the listed words", () => {
    expect(() => oneOf("micro", "macro")("until", "/kind")).toThrow('/kind: expected "micro" | "macro", got string');
  });
  it("refuses what JSON cannot hold", () => {
    expect(() => json({ deep: [undefined] }, "")).toThrow("/deep/0: expected JSON value, got undefined");
  });
});
