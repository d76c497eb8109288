import { describe, expect, it } from "vitest";
import { fit } from "../../shared/drawing/fit";
import { needsMiniMap } from "../../shared/drawing/miniMap";

describe("the mini map", () => {
  const drawing = { width: 8000, height: 3000 };
  const canvas = { width: 1300, height: 700 };

  it("does not cover a drawing that is seen as a whole", () => expect(needsMiniMap(fit(drawing, canvas), drawing, canvas)).toBe(false));
  it("is there once a part of the drawing is not seen", () => expect(needsMiniMap({ x: 0, y: 0, zoom: 1 }, drawing, canvas)).toBe(true));
  it("does not stand on a narrow canvas", () => expect(needsMiniMap({ x: 0, y: 0, zoom: 1 }, drawing, { width: 800, height: 700 })).toBe(false));
});
