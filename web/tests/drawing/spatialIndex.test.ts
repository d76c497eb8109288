// The index finds what a look at every box finds, and looks at few.
import { describe, expect, it } from "vitest";
import type { Box } from "../../shared/drawing/drawing";
import { spatialIndex } from "../../shared/drawing/spatialIndex";
import { noWork } from "../../shared/drawing/work";
import { randomOf } from "../edit/random";

const meets = (a: Box, b: Box): boolean => a.x <= b.x + b.width && b.x <= a.x + a.width && a.y <= b.y + b.height && b.y <= a.y + a.height;

describe.each(Array.from({ length: 20 }, (_, seed) => seed))("random boxes (seed %i)", (seed) => {
  const random = randomOf(seed);
  const side = () => (random.chance(0.05) ? random.pick(9000) : random.pick(300));
  const box = (): Box => ({ x: random.pick(6000) - 3000, y: random.pick(4000) - 2000, width: side(), height: side() });
  const boxes = Array.from({ length: 200 }, box);
  const index = spatialIndex(boxes.slice(0, 150));
  boxes.slice(150).forEach((each) => index.add(each));

  it("are found by an area, in their order", () => {
    for (let i = 0; i < 60; i++) {
      const area = box();
      expect(index.within(area)).toEqual(boxes.filter((each) => meets(each, area)));
    }
  });
  it("are counted up to a limit", () => {
    for (let i = 0; i < 60; i++) {
      const area = box();
      const all = boxes.filter((each) => meets(each, area) && each.x > 0).length;
      for (const most of [0, 1, 3]) expect(index.count(area, ({ x }) => x > 0, most)).toBe(Math.min(most, all));
      expect(index.count(area, ({ x }) => x > 0)).toBe(all);
    }
  });
});

describe("the work of an index", () => {
  it("is that of the cells that an area lies in, and of the boxes there", () => {
    const work = noWork();
    const index = spatialIndex(Array.from({ length: 10_000 }, (_, i) => ({ x: 300 * (i % 100), y: 100 * Math.floor(i / 100), width: 200, height: 60 })), work);
    index.within({ x: 5000, y: 5000, width: 200, height: 200 });
    expect(work.looks).toBeLessThan(40);
  });
  it("ends when enough is counted", () => {
    const work = noWork();
    const index = spatialIndex(Array.from({ length: 1000 }, () => ({ x: 0, y: 0, width: 200, height: 60 })), work);
    expect(index.count({ x: 0, y: 0, width: 10, height: 10 }, () => true, 3)).toBe(3);
    expect(work.looks).toBeLessThan(10);
  });
});
