// Windows of nearly the same shape share their layouts.
import { describe, expect, it } from "vitest";
import { aspectFor, kAspects } from "../../shared/drawing/aspect";

describe("the aspect for a drawing", () => {
  it.each(kAspects)("is %s itself in a room of this shape", (aspect) => expect(aspectFor({ width: 1000 * aspect, height: 1000 })).toBe(aspect));
  it("is off by a sixth at most between the least and the largest", () => {
    for (let width = 600; width <= 2400; width += 7) {
      const ratio = aspectFor({ width, height: 1000 }) / (width / 1000);
      expect(Math.max(ratio, 1 / ratio)).toBeLessThan(1.17);
    }
  });
  it("has bounds, for a room without height or width, too", () => {
    expect(aspectFor({ width: 1e6, height: 1 })).toBe(2.4);
    expect(aspectFor({ width: 1, height: 1e6 })).toBe(0.6);
    expect(aspectFor({ width: 0, height: 0 })).toBe(0.6);
  });
});
