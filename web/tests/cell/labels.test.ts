import { describe, expect, it } from "vitest";
import { apart, type Label } from "../../shared/cell/labels";

const view = { width: 300, height: 200 };
const label = (x: number, y: number): Label => ({ x, y, width: 40, height: 20 });
const covers = (labels: readonly Label[]) =>
  labels.some((a, i) => labels.slice(i + 1).some((b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height));

describe("apart", () => {
  it("leaves labels where they are while none covers another", () => {
    const labels = [label(10, 100), label(60, 100), label(10, 130)];
    expect(apart(labels, view)).toEqual(labels);
  });
  it.each([[[label(10, 100), label(12, 104), label(20, 98)]], [[label(280, 190), label(290, 199), label(270, 195)]], [[label(-20, -5), label(-9, 3)]], [Array.from({ length: 8 }, () => label(50, 90))]])(
    "takes %j apart, in their order, inside of the view",
    (labels) => {
      const places = apart(labels, view);
      expect(places.length).toBe(labels.length);
      expect(covers(places)).toBe(false);
      for (const { x, y } of places) expect(x >= 0 && y >= 0 && x <= 260 && y <= 180).toBe(true);
    },
  );
});
