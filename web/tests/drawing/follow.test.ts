import { describe, expect, it } from "vitest";
import { becameActive, commonLevel, followView } from "../../shared/drawing/follow";
import { fit, kTop } from "../../shared/drawing/fit";
import { kPortsLegible } from "../../shared/drawing/levels";

const canvas = { width: 800, height: 500 };
const large = { width: 4000, height: 3000 };
const box = { x: 3000, y: 2000, width: 120, height: 60 };

describe("what became active", () => {
  it("is the innermost of what was not active before", () => {
    expect(becameActive(new Set(["R", "R/A"]), new Set(["R", "R/B", "R/B/C", "R/AA"]))).toEqual(["R/B/C", "R/AA"]);
    expect(becameActive(new Set(["R", "R/B", "R/B/C"]), new Set(["R", "R/B"]))).toEqual([]);
  });
  it("is shown by the level that all of it is in", () => {
    expect(commonLevel(["R/A/B"])).toBe("R/A");
    expect(commonLevel(["R/A/B", "R/A/C/D"])).toBe("R/A");
    expect(commonLevel(["R/A/B", "R/AB/B"])).toBe("R");
    expect(commonLevel(["R"])).toBe("");
  });
});

describe("the view that follows", () => {
  it("is the whole drawing where that can be read", () => {
    const small = { width: 500, height: 300 };
    const whole = fit(small, canvas);
    expect(followView([box], { x: 0, y: 0, zoom: 0.3 }, small, canvas)).toEqual(whole);
    expect(followView([box], whole, small, canvas)).toBeUndefined();
  });
  it("is the whole drawing while nothing is active", () => expect(followView([], { x: 0, y: 0, zoom: 1 }, large, canvas)).toEqual(fit(large, canvas)));
  it("has the boxes below the tools, and legible", () => {
    const view = followView([box], fit(large, canvas), large, canvas);
    if (view === undefined) throw new Error("it does not move");
    expect(view.zoom).toBeCloseTo(kPortsLegible);
    const [left, top] = [view.x + box.x * view.zoom, view.y + box.y * view.zoom];
    expect(left).toBeGreaterThan(0);
    expect(top).toBeGreaterThan(kTop);
    expect(left + box.width * view.zoom).toBeLessThan(canvas.width);
    expect(top + box.height * view.zoom).toBeLessThan(canvas.height);
    // There, it rests; and while the next one is near.
    expect(followView([box], view, large, canvas)).toBeUndefined();
    expect(followView([{ ...box, x: box.x + 100 }], view, large, canvas)).toBeUndefined();
    expect(followView([{ ...box, x: box.x + 900 }], view, large, canvas)).toBeDefined();
  });
  it("shows what is apart as a whole, smaller", () => {
    const view = followView([box, { ...box, x: 200 }], { x: 0, y: 0, zoom: 1 }, large, canvas);
    expect(view?.zoom).toBeLessThan(kPortsLegible);
    expect((view?.x ?? -1) + 200 * (view?.zoom ?? 1)).toBeGreaterThan(0);
  });
});
