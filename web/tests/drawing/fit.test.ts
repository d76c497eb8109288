import { describe, expect, it } from "vitest";
import { fit, fitReadable, shows } from "../../shared/drawing/fit";
import { kPortsLegible } from "../../shared/drawing/levels";
import { roundedPath } from "../../shared/drawing/path";

const canvas = { width: 1000, height: 640 };

describe("fit", () => {
  it.each([
    { width: 400, height: 300 },
    { width: 4000, height: 300 },
    { width: 400, height: 3000 },
  ])("shows all of a drawing of $width by $height, below the breadcrumb", (drawing) => {
    const view = fit(drawing, canvas);
    expect(view.x).toBeGreaterThanOrEqual(0);
    expect(view.y).toBeGreaterThanOrEqual(44);
    expect(view.x + drawing.width * view.zoom).toBeLessThanOrEqual(canvas.width);
    expect(view.y + drawing.height * view.zoom).toBeLessThanOrEqual(canvas.height);
  });
  it("does not blow a small drawing up", () => expect(fit({ width: 10, height: 10 }, canvas).zoom).toBe(1.25));
});

describe("what is seen", () => {
  it("is all of a drawing that was fitted, until it grows out of the canvas", () => {
    const view = fit({ width: 400, height: 300 }, canvas);
    expect(shows(view, { width: 400, height: 300 }, canvas)).toBe(true);
    expect(shows(view, { width: 800, height: 300 }, canvas)).toBe(false);
    expect(shows(view, { width: 400, height: 600 }, canvas)).toBe(false);
    expect(shows({ ...view, x: -1 }, { width: 400, height: 300 }, canvas)).toBe(false);
  });
});

describe("fitReadable", () => {
  it("shows all of a drawing whose code can be read then", () => {
    const drawing = { width: 900, height: 500 };
    expect(fitReadable(drawing, canvas)).toEqual(fit(drawing, canvas));
  });
  it("is as wide as the canvas where that makes code larger, and no larger than written", () => {
    const wide = fitReadable({ width: 1020, height: 3000 }, canvas);
    expect(wide.zoom).toBeGreaterThan(kPortsLegible);
    expect(wide.x + 1020 * wide.zoom).toBeCloseTo(canvas.width - wide.x);
    expect(fitReadable({ width: 300, height: 3000 }, canvas).zoom).toBe(1);
  });
  it("does not make code smaller than it can be read to show the whole width", () => {
    const view = fitReadable({ width: 9000, height: 3000 }, canvas);
    expect([view.zoom, view.x, view.y]).toEqual([kPortsLegible, 14, 50]);
  });
  it("shows the beginning of a larger one, at a size at which its code can be read", () => {
    const view = fitReadable({ width: 700, height: 9000 }, canvas);
    expect(view.zoom).toBeGreaterThan(0.62);
    expect(view.y).toBe(50);
    expect(view.x + 350 * view.zoom).toBeCloseTo(500);
  });
});

describe("roundedPath", () => {
  it("rounds corners, and never beyond the middle of a short piece", () => {
    const path = roundedPath([{ x: 0, y: 0 }, { x: 4, y: 0 }, { x: 4, y: 100 }], 10);
    expect(path).toBe("M 0 0 L 2 0 Q 4 0 4 10 L 4 100");
  });
});
