// The spatial index, and what of a drawing lies at a point.
import { describe, expect, it } from "vitest";
import { hitIndex } from "../../shared/drawing/hit";
import type { Box, DrawnNode, DrawnPort } from "../../shared/drawing/drawing";
import { spatialIndex } from "../../shared/drawing/spatialIndex";

const box = (x: number, y: number, width: number, height: number): Box => ({ x, y, width, height });

describe("spatialIndex", () => {
  it("finds what a plain search finds, in the same order, in small and large areas", () => {
    // A fixed pattern of boxes of many sizes, some of them over the whole plane.
    const items = Array.from({ length: 500 }, (_, i) => box((i * 7919) % 9000, (i * 104_729) % 7000, 1 + ((i * 31) % 400), i % 50 === 0 ? 7000 : 1 + ((i * 17) % 300)));
    const index = spatialIndex(items);
    const areas = [box(0, 0, 9000, 7000), box(4000, 3000, 50, 50), box(-100, -100, 150, 150), box(2000, 100, 1500, 900), box(20_000, 0, 10, 10)];
    for (const area of areas) {
      const plain = items.filter((item) => item.x <= area.x + area.width && area.x <= item.x + item.width && item.y <= area.y + area.height && area.y <= item.y + item.height);
      expect(index.within(area)).toEqual(plain);
    }
  });

  it("finds what contains a point, its border too", () => {
    const index = spatialIndex([box(0, 0, 1000, 1000), box(10, 10, 20, 20)]);
    expect(index.at({ x: 30, y: 30 })).toHaveLength(2);
    expect(index.at({ x: 31, y: 30 })).toHaveLength(1);
    expect(index.at({ x: 1001, y: 0 })).toHaveLength(0);
  });
});

describe("hitIndex", () => {
  const port = (address: string, at: Box): DrawnPort => ({ ...at, address, name: "done", condition: "", when: "", timed: false, exits: false });
  const state = (path: string, depth: number, at: Box, ports: readonly DrawnPort[] = []): DrawnNode => ({ ...at, kind: "state", path, name: path, depth, composite: false, open: false, lines: [], ports, side: "EAST" });
  const drawing = {
    width: 400,
    height: 300,
    lines: [],
    nodes: [state("R", 0, box(0, 0, 400, 300)), state("R/A", 1, box(50, 50, 100, 60), [port("R/A.done", box(136, 60, 54, 29))]), state("R/B", 1, box(180, 50, 100, 60))],
  };
  const { at } = hitIndex(drawing);

  it("finds the innermost node", () => {
    expect(at({ x: 60, y: 60 })).toEqual({ path: "R/A" });
    expect(at({ x: 10, y: 10 })).toEqual({ path: "R" });
    expect(at({ x: 500, y: 10 })).toBeUndefined();
  });

  it("finds a port outside the border of its state, and over a sibling", () => {
    expect(at({ x: 165, y: 70 })).toEqual({ path: "R/A", port: "R/A.done" });
    expect(at({ x: 185, y: 70 })).toEqual({ path: "R/A", port: "R/A.done" });
  });

  it("is made once for a drawing", () => {
    expect(hitIndex(drawing)).toBe(hitIndex(drawing));
  });
});
