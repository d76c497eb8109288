// Orthogonal lines around boxes. Of a few simple lines the best is taken; where each of them crosses a box, a search looks for a way
// around (routeSearch.ts), as long as the level has work left for it.
import type { Box, Point, Side } from "./drawing";
import { findWay, kMostObstacles } from "./routeSearch";
import { spatialIndex, type SpatialIndex } from "./spatialIndex";
import { noWork, type Work } from "./work";

/** One end of a line: it leaves its box, or enters it, across this border. */
export interface RouteEnd {
  readonly point: Point;
  readonly side: Side;
  /** The box with its ports. */
  readonly hull: Box;
}

export interface Route {
  readonly from: RouteEnd;
  /** Lines enter through the border that is opposite to `side`. */
  readonly to: RouteEnd;
}

/** From a box to the first bend of a line, and between lines beside each other [px]. */
const kNear = 8;
const kLane = 4;
const kLanes = 3;
/** Steps of searches for all lines of a level. */
const kMostSearch = 120_000;

const spanning = (points: readonly Point[], margin = 0): Box => {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  const [x, y] = [Math.min(...xs) - margin, Math.min(...ys) - margin];
  return { x, y, width: Math.max(...xs) + margin - x, height: Math.max(...ys) + margin - y };
};

/** Without points that are the same as the one before or in the middle of a straight piece. */
function tidy(points: readonly Point[]): readonly Point[] {
  const kept: Point[] = [];
  for (const point of points) {
    const [before, last] = [kept.at(-2), kept.at(-1)];
    if (last?.x === point.x && last.y === point.y) continue;
    if (before !== undefined && last !== undefined && ((before.x === last.x && last.x === point.x) || (before.y === last.y && last.y === point.y))) kept.pop();
    kept.push(point);
  }
  return kept;
}

/** How often a line crosses boxes, counted up to `most`; touching a border is no crossing. */
export function crossings(boxes: SpatialIndex<Box>, points: readonly Point[], most = Infinity): number {
  let sum = 0;
  for (let i = 1; i < points.length && sum < most; i++) {
    const [from, to] = [points[i - 1], points[i]];
    if (from === undefined || to === undefined) continue;
    const piece = { x: Math.min(from.x, to.x), y: Math.min(from.y, to.y), width: Math.abs(to.x - from.x), height: Math.abs(to.y - from.y) };
    sum += boxes.count(piece, (box) => crosses(piece, box), most - sum);
  }
  return sum;
}

const crosses = (piece: Box, { x, y, width, height }: Box): boolean =>
  piece.x < x + width - 1 && x + 1 < piece.x + piece.width && piece.y < y + height - 1 && y + 1 < piece.y + piece.height;

/** What a crossed box costs, as a length: more than any way around it. */
const kCrossing = 1e5;

/** Long lines and bends are hard to read. */
const length = (points: readonly Point[]): number =>
  points.slice(1).reduce((sum, { x, y }, i) => sum + Math.abs(x - (points[i]?.x ?? x)) + Math.abs(y - (points[i]?.y ?? y)), points.length * 24);

/** The way that costs least, and its cost. Shorter ways first, so that most are not looked at once one crosses nothing. */
function bestOf(boxes: SpatialIndex<Box>, ways: readonly (readonly Point[])[], work: Work): { readonly way: readonly Point[]; readonly cost: number } {
  const rated = ways.map((way) => [way, tidy(way)] as const).map(([way, tidied]) => ({ way, tidied, least: length(tidied) }));
  let best: { readonly way: readonly Point[]; readonly cost: number } = { way: ways[0] ?? [], cost: Infinity };
  for (const { way, tidied, least } of rated.sort((a, b) => a.least - b.least)) {
    if (least >= best.cost) break;
    work.steps++;
    const bearable = Math.ceil((best.cost - least) / kCrossing);
    const cost = crossings(boxes, tidied, bearable) * kCrossing + least;
    if (cost < best.cost) best = { way, cost };
  }
  return best;
}

/** The lines with at most two bends between the ends' first and last ones. */
function simpleWays(start: Point, end: Point, from: Box, to: Box, gap: number): readonly (readonly Point[])[] {
  const columns = [(start.x + end.x) / 2, Math.min(from.x, to.x) - gap, Math.max(from.x + from.width, to.x + to.width) + gap];
  const rows = [(start.y + end.y) / 2, Math.min(from.y, to.y) - gap, Math.max(from.y + from.height, to.y + to.height) + gap];
  return [
    [start, { x: start.x, y: end.y }, end],
    [start, { x: end.x, y: start.y }, end],
    ...columns.map((x) => [start, { x, y: start.y }, { x, y: end.y }, end]),
    ...rows.map((y) => [start, { x: start.x, y }, { x: end.x, y }, end]),
  ];
}

function routeOne({ from, to }: Route, lane: number, boxes: SpatialIndex<Box>, search: Work, work: Work): readonly Point[] {
  const gap = kNear + kLane * (lane % kLanes);
  const start = from.side === "EAST" ? { x: from.hull.x + from.hull.width + gap, y: from.point.y } : { x: from.point.x, y: from.hull.y + from.hull.height + gap };
  const end = to.side === "EAST" ? { x: to.point.x - gap, y: to.point.y } : { x: to.point.x, y: to.point.y - gap };
  const straight = from.side === to.side && (from.side === "EAST" ? from.point.y === to.point.y && start.x <= end.x : from.point.x === to.point.x && start.y <= end.y);
  const ways = straight ? [[start, end]] : simpleWays(start, end, from.hull, to.hull, gap);
  const best = bestOf(boxes, ways, work);
  const whole = (way: readonly Point[]) => tidy([from.point, ...way, to.point]);
  if (best.cost < kCrossing || search.steps >= kMostSearch) return whole(best.way);
  const around = spanning([start, end], 160);
  if (boxes.count(around, () => true, kMostObstacles + 1) > kMostObstacles) return whole(best.way);
  const near = boxes.within(around);
  const before = search.steps;
  const found = findWay(start, end, from.side, to.side, near, gap, search);
  work.steps += search.steps - before;
  return whole(found ?? best.way);
}

/** The lines of one level in order, around `hulls`. What they cost grows with their number; that of searches is bounded for all together. */
export function routeLines(hulls: readonly Box[], routes: readonly Route[], work: Work = noWork()): readonly (readonly Point[])[] {
  const boxes = spatialIndex(hulls, work);
  const search = noWork();
  return routes.map((route, i) => routeOne(route, i, boxes, search, work));
}
