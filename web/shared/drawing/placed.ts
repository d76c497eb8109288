// A level in which somebody has placed children: those stay where they are, the others give way; the frame is as large as all need,
// and lines are routed around the boxes.
import { portAddress, type State } from "../model/model";
import { linesOf, type ChildBox, type LineSpec } from "./compositeGraph";
import type { Box, Point, Side } from "./drawing";
import { endsOf, firstArrow, hullOf, levelBox, routeOf, type LevelBox } from "./levelLines";
import { headSize, portInset, portSize, type Detail, type Size } from "./measure";
import { crossings, routeLines, type Route } from "./route";
import { settle } from "./settle";
import { spatialIndex, type SpatialIndex } from "./spatialIndex";
import { noWork, type Work } from "./work";

/** Between the frame and its children; to the right and below there is room for lines, too [px]. */
const kMargin = { left: 18, top: 16, right: 40, bottom: 34 };
const kPortGap = 8;

/** Where the content area begins in the frame of a composite, unless a child lies left of or above it. */
export const contentOrigin = (state: State, detail: Detail): Point => ({ x: kMargin.left, y: headSize(state, detail).height + kMargin.top });

/** A child with its place in the content area. */
export interface PlacedChild extends ChildBox {
  readonly side: Side;
  readonly at: Point;
  /** A person has placed it, so it stays. */
  readonly pinned: boolean;
}

/** A laid out level, in the coordinates of its frame. */
export interface PlacedLevel {
  readonly size: Size;
  /** The ports of the frame, in the order of their declaration. */
  readonly ports: readonly Box[];
  readonly content: Point;
  readonly at: ReadonlyMap<string, Point>;
  readonly lines: readonly (LineSpec & { readonly points: readonly Point[] })[];
}

const shifted = (at: Point, by: Point): Point => ({ x: at.x + by.x, y: at.y + by.y });
const boxAt = ({ node, path, size, ports, side }: PlacedChild, at: Point): LevelBox => levelBox(node, path, at, size, ports, side);

/** The children that somebody has placed, and the others where they are free; in the order of `children`. */
function settled(children: readonly PlacedChild[], work: Work): readonly Point[] {
  const hull = (child: PlacedChild) => hullOf(boxAt(child, child.at));
  const free = children.filter(({ pinned }) => !pinned);
  const hulls = free.map(hull);
  const moved = settle(children.filter(({ pinned }) => pinned).map(hull), hulls, work);
  const places = new Map(free.map((child, i): [PlacedChild, Point] => {
    const [from, to] = [hulls[i] ?? child.at, moved[i] ?? child.at];
    return [child, { x: child.at.x + to.x - from.x, y: child.at.y + to.y - from.y }];
  }));
  return children.map((child) => places.get(child) ?? child.at);
}

/** The ports of a frame, in the middle of its border. */
function frameSizeAndPorts(state: State, side: Side, detail: Detail, inner: Size): { readonly size: Size; readonly ports: readonly Box[] } {
  const sizes = state.ports.map((port) => portSize(port, detail));
  const head = headSize(state, detail);
  const along = (size: Size) => (side === "EAST" ? size.height : size.width);
  const length = sizes.reduce((sum, size) => sum + along(size) + kPortGap, kPortGap);
  const least = side === "EAST" ? { width: head.width + portInset, height: head.height + length } : { width: Math.max(head.width, length), height: head.height + 60 };
  const size = { width: Math.max(inner.width, least.width), height: Math.max(inner.height, least.height, head.height + 60) };
  const free = side === "EAST" ? size.height - head.height : size.width;
  let next = (side === "EAST" ? head.height : 0) + (free - length) / 2 + kPortGap;
  const ports = sizes.map((port) => {
    const at = next;
    next += along(port) + kPortGap;
    return side === "EAST" ? { ...port, x: size.width - portInset, y: at } : { ...port, x: at, y: size.height - portInset };
  });
  return { size, ports };
}

/** The way that a line has already, if it still leads from end to end and past all boxes. */
function kept(way: readonly Point[] | undefined, { from, to }: Route, boxes: SpatialIndex<Box>): readonly Point[] | undefined {
  const near = (a: Point | undefined, b: Point) => a !== undefined && Math.abs(a.x - b.x) < 1 && Math.abs(a.y - b.y) < 1;
  if (way === undefined || !near(way[0], from.point) || !near(way.at(-1), to.point)) return undefined;
  // A line begins inside of its own hull where other ports are longer.
  return crossings(boxes, way) <= crossings(spatialIndex([from.hull]), way) ? way : undefined;
}

/** `ways`: those that lines have in the content area, before anything has given way; they are kept where nothing has changed. */
export function placedLevel(state: State, path: string, side: Side, detail: Detail, children: readonly PlacedChild[], ways: ReadonlyMap<string, readonly Point[]>, work: Work = noWork()): PlacedLevel {
  const places = settled(children, work);
  const origin = contentOrigin(state, detail);
  const content = { x: origin.x - places.reduce((least, { x }) => Math.min(least, x), 0), y: origin.y - places.reduce((least, { y }) => Math.min(least, y), 0) };
  const boxes = children.map((child, i) => boxAt(child, shifted(places[i] ?? child.at, content)));
  const hulls = boxes.map(hullOf);
  const border = (margin: number, borderSide: Side) => margin + (side === borderSide ? portInset : 0);
  const { size, ports } = frameSizeAndPorts(state, side, detail, {
    width: hulls.reduce((most, hull) => Math.max(most, hull.x + hull.width), content.x) + border(kMargin.right, "EAST"),
    height: hulls.reduce((most, hull) => Math.max(most, hull.y + hull.height), content.y) + border(kMargin.bottom, "SOUTH"),
  });
  const frame = new Map(state.ports.flatMap((port, i) => {
    const box = ports[i];
    return box === undefined ? [] : [[portAddress(path, port), box] as const];
  }));
  return { size, ports, content, at: new Map(boxes.map(({ path: at, box }) => [at, { x: box.x, y: box.y }])), lines: linesBetween(linesOf(state, path), boxes, hulls, frame, side, content, ways, work) };
}

function linesBetween(specs: readonly LineSpec[], boxes: readonly LevelBox[], hulls: readonly Box[], frame: ReadonlyMap<string, Box>, side: Side, content: Point, ways: ReadonlyMap<string, readonly Point[]>, work: Work): PlacedLevel["lines"] {
  const ends = endsOf(boxes, frame, side);
  const index = spatialIndex(hulls);
  const points = new Map<string, readonly Point[]>();
  const routes: { readonly id: string; readonly route: Route }[] = [];
  for (const line of specs) {
    const first = line.kind === "first" ? ends.nodes.get(line.to) : undefined;
    const route = routeOf(line, ends);
    if (first !== undefined) points.set(line.id, firstArrow(first));
    else if (route !== undefined) {
      const way = kept(ways.get(line.id)?.map((point) => shifted(point, content)), route, index);
      if (way === undefined) routes.push({ id: line.id, route });
      else points.set(line.id, way);
    }
  }
  const routed = routeLines(hulls, routes.map(({ route }) => route), work);
  routes.forEach(({ id }, i) => points.set(id, routed[i] ?? []));
  return specs.flatMap((line) => {
    const found = points.get(line.id);
    return found === undefined ? [] : [{ ...line, points: found }];
  });
}
