// Boxes that nobody has placed give way to those that somebody has: each goes to the nearest free place.
import type { Box, Point } from "./drawing";
import { spatialIndex, type SpatialIndex } from "./spatialIndex";
import { noWork, type Work } from "./work";

/** Between boxes [px]. */
const kGap = 16;
/** Places that are tried for one box; then it goes below all others. */
const kMostTries = 80;

const around = ({ x, y, width, height }: Box): Box => ({ x: x - kGap, y: y - kGap, width: width + 2 * kGap, height: height + 2 * kGap });
const overlaps = (a: Box, b: Box): boolean => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** The boxes that are too near to `box`. */
const inTheWay = (taken: SpatialIndex<Box>, box: Box): readonly Box[] => taken.within(around(box)).filter((other) => overlaps(around(box), other));

/** The places beside `other` to which `box` can give way; none left of or above the content area. */
function beside(box: Box, other: Box): readonly Box[] {
  const moved = [
    { ...box, x: other.x + other.width + kGap },
    { ...box, y: other.y + other.height + kGap },
    { ...box, x: other.x - box.width - kGap },
    { ...box, y: other.y - box.height - kGap },
  ];
  return moved.filter(({ x, y }) => x >= 0 && y >= 0);
}

function freePlace(taken: SpatialIndex<Box>, box: Box, bottom: number, work: Work): Box {
  const far = ({ x, y }: Box) => Math.abs(x - box.x) + Math.abs(y - box.y);
  const seen = new Set<string>();
  const open: Box[] = [box];
  for (let tries = 0; tries < kMostTries && open.length > 0; ++tries) {
    work.steps++;
    const at = open.reduce((best, each) => (far(each) < far(best) ? each : best));
    open.splice(open.indexOf(at), 1);
    const blockers = inTheWay(taken, at);
    if (blockers.length === 0) return at;
    // Of many that it overlaps, any few lead away.
    for (const next of blockers.slice(0, 4).flatMap((other) => beside(at, other))) {
      const key = `${next.x} ${next.y}`;
      if (!seen.has(key)) open.push(next);
      seen.add(key);
    }
  }
  return { ...box, y: Math.max(0, bottom + kGap) };
}

/** Where `free` boxes go: they stay where they are unless they overlap one of `fixed`, or each other then. In their order. */
export function settle(fixed: readonly Box[], free: readonly Box[], work: Work = noWork()): readonly Point[] {
  const taken = spatialIndex(fixed, work);
  const undisturbed = free.map((box) => (work.steps++, inTheWay(taken, box).length === 0));
  free.forEach((box, i) => undisturbed[i] === true && taken.add(box));
  let bottom = [...fixed, ...free].reduce((most, box) => Math.max(most, box.y + box.height), 0);
  return free.map((box, i) => {
    if (undisturbed[i] === true) return box;
    const at = freePlace(taken, box, bottom, work);
    bottom = Math.max(bottom, at.y + at.height);
    taken.add(at);
    return at;
  });
}
