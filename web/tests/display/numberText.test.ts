import { describe, expect, it } from "vitest";
import { keyOf, limits, press, proposed, read, type Key } from "../../shared/display/numberText";

const typed = (keys: readonly Key[], from = ""): string => keys.reduce(press, from);

describe("the keypad", () => {
  it("writes digits and one point", () => {
    expect(typed(["1", "2", ".", "5", ".", "0"])).toBe("12.50");
  });
  it("puts a zero before a leading point and none before a digit", () => {
    expect(typed([".", "5"])).toBe("0.5");
    expect(typed(["sign", ".", "5"])).toBe("-0.5");
    expect(typed(["0", "0", "7"])).toBe("7");
    expect(typed(["0", "sign", "7"])).toBe("-7");
  });
  it("turns the sign over and takes characters back", () => {
    expect(typed(["4", "sign"])).toBe("-4");
    expect(typed(["4", "sign", "sign"])).toBe("4");
    expect(typed(["4", "2", "back"])).toBe("4");
    expect(typed(["back"])).toBe("");
  });
  it("does not grow without end", () => {
    expect(typed(Array.from({ length: 40 }, (): Key => "9")).length).toBe(12);
  });
  it("maps keys of a keyboard", () => {
    expect(["7", ",", ".", "-", "Backspace", "a", "Enter"].map(keyOf)).toEqual(["7", ".", ".", "sign", "back", undefined, undefined]);
  });
});

describe("what was entered", () => {
  const width = { unit: "m", min: -1, max: 0.11 };
  it("is a number within the limits, ends included", () => {
    expect(read("0.11", width)).toEqual({ value: 0.11 });
    expect(read("-1", width)).toEqual({ value: -1 });
    expect(read("0.", width)).toEqual({ value: 0 });
  });
  it("says what is wrong with it", () => {
    expect(read("", width)).toEqual({ problem: "Enter a number" });
    expect(read("-", width)).toEqual({ problem: "Enter a number" });
    expect(read("-2", width)).toEqual({ problem: "At least -1 m" });
    expect(read("3", width)).toEqual({ problem: "At most 0.11 m" });
    expect(read("3", { ...width, unit: "" })).toEqual({ problem: "At most 0.11" });
  });
  it("starts from what is proposed", () => {
    expect(proposed({ ...width, value: 0.03 })).toBe("0.03");
    expect(proposed(width)).toBe("");
    expect(limits(width)).toBe("-1 to 0.11 m");
  });
});
