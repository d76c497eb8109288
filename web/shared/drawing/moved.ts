// A drawing while something in it is dragged: what is moved goes along with all in it, and the lines to and from it follow.
import { ownerOf } from "../model/modelTree";
import type { DrawnLine, DrawnNode, Drawing, Point } from "./drawing";
import { endsOf, hullOf, routeOf, type LevelBox } from "./levelLines";
import { routeLines } from "./route";

const shift = <T extends Point>(item: T, by: Point): T => ({ ...item, x: item.x + by.x, y: item.y + by.y });
const asBox = (node: DrawnNode): LevelBox => ({ path: node.path, box: node, side: node.side, kind: node.kind, ports: node.ports });
const parentOf = (path: string): string => path.slice(0, path.lastIndexOf("/"));

/** `paths`: nodes of one level. */
export function movedDrawing(drawing: Drawing, paths: readonly string[], by: Point): Drawing {
  const isMoved = (path: string) => paths.some((root) => path === root || path.startsWith(`${root}/`));
  const nodes = drawing.nodes.map((node) => (isMoved(node.path) ? { ...shift(node, by), ports: node.ports.map((port) => shift(port, by)) } : node));
  const parent = nodes.find(({ path }) => path === parentOf(paths[0] ?? ""));
  if (parent === undefined) return drawing;
  const level = nodes.filter(({ path, depth }) => depth === parent.depth + 1 && parentOf(path) === parent.path).map(asBox);
  const ends = endsOf(level, new Map(parent.ports.map((port) => [port.address, port])), parent.side);
  const touches = ({ from, to }: DrawnLine) => paths.includes(ownerOf(from)) || (to !== undefined && paths.includes(ownerOf(to)));
  const routes = drawing.lines.flatMap((line) => {
    const route = line.depth === parent.depth + 1 && line.kind !== "first" && touches(line) && line.to !== undefined ? routeOf({ from: line.from, to: line.to }, ends) : undefined;
    return route === undefined ? [] : [{ id: line.id, route }];
  });
  const ways = routeLines(level.map(hullOf), routes.map(({ route }) => route));
  const routed = new Map(routes.map(({ id }, i) => [id, ways[i] ?? []]));
  const lines = drawing.lines.map((line): DrawnLine => {
    const way = routed.get(line.id);
    if (way !== undefined) return { ...line, points: way };
    const along = isMoved(ownerOf(line.from)) || (line.kind === "first" && paths.includes(line.to ?? ""));
    return along ? { ...line, points: line.points.map((point) => shift(point, by)) } : line;
  });
  return { ...drawing, nodes, lines };
}
