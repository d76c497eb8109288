// Where the lines of one level begin and end, whatever has placed its boxes, and the routes between.
import { portAddress, type Node } from "../model/model";
import type { LineSpec } from "./compositeGraph";
import type { Box, Point, Side } from "./drawing";
import type { Route, RouteEnd } from "./route";

/** A node of a level, in the coordinates of the level. */
export interface LevelBox {
  readonly path: string;
  readonly box: Box;
  readonly side: Side;
  readonly kind: Node["kind"];
  readonly ports: readonly (Box & { readonly address: string })[];
}

/** A box with its ports: what is not to be covered. */
export function hullOf({ box, ports }: Pick<LevelBox, "box" | "ports">): Box {
  const all = [box, ...ports];
  const [x, y] = [Math.min(...all.map((each) => each.x)), Math.min(...all.map((each) => each.y))];
  return { x, y, width: Math.max(...all.map((each) => each.x + each.width)) - x, height: Math.max(...all.map((each) => each.y + each.height)) - y };
}

/** Where lines enter a node, from its corner. */
export const inletPoint = ({ width, height }: Pick<Box, "width" | "height">, side: Side): Point => (side === "EAST" ? { x: 0, y: Math.min(16, height / 2) } : { x: width / 2, y: 0 });

const outletOf = ({ x, y, width, height }: Box, side: Side): Point => (side === "EAST" ? { x: x + width, y: y + height / 2 } : { x: x + width / 2, y: y + height });

/** Where a line from inside ends at a port of the frame. */
const exitOf = ({ x, y, width, height }: Box, side: Side): Point => (side === "EAST" ? { x, y: y + height / 2 } : { x: x + width / 2, y });

/** The boxes of a level by path and by the addresses of their ports. */
export interface Ends {
  readonly nodes: ReadonlyMap<string, LevelBox>;
  readonly ports: ReadonlyMap<string, { readonly node: LevelBox; readonly port: Box }>;
  /** The ports of the state whose level it is, by address. */
  readonly frame: ReadonlyMap<string, Box>;
  readonly frameSide: Side;
}

export function endsOf(nodes: readonly LevelBox[], frame: ReadonlyMap<string, Box>, frameSide: Side): Ends {
  return {
    nodes: new Map(nodes.map((node) => [node.path, node])),
    ports: new Map(nodes.flatMap((node) => node.ports.map((port) => [port.address, { node, port }] as const))),
    frame,
    frameSide,
  };
}

function sourceOf({ from }: Pick<LineSpec, "from">, { nodes, ports }: Ends): RouteEnd | undefined {
  const found = ports.get(from);
  if (found !== undefined) return { point: outletOf(found.port, found.node.side), side: found.node.side, hull: hullOf(found.node) };
  const node = nodes.get(from);
  return node && { point: outletOf(node.box, node.side), side: node.side, hull: hullOf(node) };
}

function targetOf({ to }: { readonly to: string }, { nodes, frame, frameSide }: Ends): RouteEnd | undefined {
  const port = frame.get(to);
  if (port !== undefined) return { point: exitOf(port, frameSide), side: frameSide, hull: port };
  const node = nodes.get(to);
  if (node === undefined) return undefined;
  const inlet = inletPoint(node.box, node.side);
  return { point: { x: node.box.x + inlet.x, y: node.box.y + inlet.y }, side: node.side, hull: hullOf(node) };
}

/** The ends of a line; nothing if one of them is not drawn. */
export function routeOf(line: { readonly from: string; readonly to: string }, ends: Ends): Route | undefined {
  const [from, to] = [sourceOf(line, ends), targetOf(line, ends)];
  return from && to && { from, to };
}

const kFirstArrow = 20;

/** The arrow to `first`: from a dot before the node, or from the border of the frame if that is nearer. */
export function firstArrow({ box, side }: LevelBox): readonly Point[] {
  const inlet = inletPoint(box, side);
  const end = { x: box.x + inlet.x, y: box.y + inlet.y };
  return [side === "EAST" ? { x: Math.max(0, end.x - kFirstArrow), y: end.y } : { x: end.x, y: Math.max(0, end.y - kFirstArrow) }, end];
}

/** A node of a level at this place, from its size and the boxes of its ports. */
export function levelBox(node: Node, path: string, at: Point, size: Pick<Box, "width" | "height">, ports: readonly Box[], side: Side): LevelBox {
  const placed = node.kind === "barrier" ? [] : node.ports.flatMap((port, i) => {
    const box = ports[i];
    return box === undefined ? [] : [{ ...box, x: at.x + box.x, y: at.y + box.y, address: portAddress(path, port) }];
  });
  return { path, box: { ...at, ...size }, side, kind: node.kind, ports: placed };
}
