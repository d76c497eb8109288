// A drawing while something in it is dragged: what is moved goes along with all in it, and the lines to and from it follow.
import { ownerOf } from "../model/modelTree";
import type { DrawnLine, DrawnNode, Drawing, Point } from "./drawing";
import { endsOf, hullOf, routeOf, type LevelBox } from "./levelLines";
import { routeLines } from "./route";
import { noWork, type Work } from "./work";

const shift = <T extends Point>(item: T, by: Point): T => ({ ...item, x: item.x + by.x, y: item.y + by.y });
const shiftNode = (node: DrawnNode, by: Point): DrawnNode => ({ ...shift(node, by), ports: node.ports.map((port) => shift(port, by)) });
const asBox = (node: DrawnNode): LevelBox => ({ path: node.path, box: node, side: node.side, kind: node.kind, ports: node.ports });
const parentOf = (path: string): string => path.slice(0, path.lastIndexOf("/"));

/** The paths of these nodes and of all in them: what is in a node follows it. */
function withInner({ nodes }: Drawing, roots: ReadonlySet<string>): ReadonlySet<string> {
  const found = new Set<string>();
  let above = Infinity;
  for (const { path, depth } of nodes) {
    if (depth <= above) above = roots.has(path) ? depth : Infinity;
    if (above !== Infinity) found.add(path);
  }
  return found;
}

/** What does not change while `paths`, nodes of one level, are dragged: who moves, and which lines need another way. */
function partsOf(drawing: Drawing, paths: readonly string[]) {
  const roots = new Set(paths);
  const inner = withInner(drawing, roots);
  const parent = drawing.nodes.find(({ path }) => path === parentOf(paths[0] ?? ""));
  const touches = ({ from, to }: DrawnLine) => roots.has(ownerOf(from)) || (to !== undefined && roots.has(ownerOf(to)));
  const isRouted = (line: DrawnLine) => line.depth === (parent?.depth ?? -1) + 1 && line.kind !== "first" && touches(line);
  const isCarried = (line: DrawnLine) => inner.has(ownerOf(line.from)) || (line.kind === "first" && roots.has(line.to ?? ""));
  return {
    parent,
    moved: drawing.nodes.map(({ path }) => inner.has(path)),
    level: drawing.nodes.flatMap(({ path, depth }, i) => (parent !== undefined && depth === parent.depth + 1 && parentOf(path) === parent.path ? [i] : [])),
    routed: drawing.lines.map(isRouted),
    carried: drawing.lines.map(isCarried),
  };
}

/** `paths`: nodes of one level. The result draws them moved by so much; `work` counts what routes cost. */
export function mover(drawing: Drawing, paths: readonly string[], work: Work = noWork()): (by: Point) => Drawing {
  const { parent, moved, level, routed, carried } = partsOf(drawing, paths);
  if (parent === undefined) return () => drawing;
  const frame = new Map(parent.ports.map((port) => [port.address, port]));
  return (by) => {
    const nodes = drawing.nodes.map((node, i) => (moved[i] === true ? shiftNode(node, by) : node));
    const boxes = level.flatMap((i) => nodes[i] ?? []).map(asBox);
    const ends = endsOf(boxes, frame, parent.side);
    const routes = drawing.lines.flatMap((line, i) => {
      const route = routed[i] === true && line.to !== undefined ? routeOf({ from: line.from, to: line.to }, ends) : undefined;
      return route === undefined ? [] : [{ line, route }];
    });
    const ways = routeLines(boxes.map(hullOf), routes.map(({ route }) => route), work);
    const wayOf = new Map(routes.map(({ line }, i) => [line, ways[i] ?? []]));
    const moveLine = (line: DrawnLine, i: number): DrawnLine => {
      const points = wayOf.get(line) ?? (carried[i] === true ? line.points.map((point) => shift(point, by)) : undefined);
      return points === undefined ? line : { ...line, points };
    };
    return { ...drawing, nodes, lines: drawing.lines.map(moveLine) };
  };
}
