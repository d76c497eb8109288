// A drawing prepared for painting: nodes and lines in the order in which they are painted, found by place or by what a run changes.
import { inboundPorts, splitAddress, type ModelTree } from "../model/modelTree";
import type { Box, DrawnLine, DrawnNode, DrawnPort, Drawing } from "./drawing";
import { flowLines } from "./flow";
import { spatialIndex, type SpatialIndex } from "./spatialIndex";

interface Placed extends Box {
  /** The composite that it lies in; none: it is outermost. */
  readonly inside: DrawnNode | undefined;
  readonly order: number;
}

export interface SceneNode extends Placed {
  readonly kind: "node";
  readonly node: DrawnNode;
}

export interface SceneLine extends Placed {
  readonly kind: "line";
  readonly line: DrawnLine;
}

export type SceneItem = SceneNode | SceneLine;

export interface Scene {
  readonly drawing: Drawing;
  readonly items: SpatialIndex<SceneItem>;
  readonly node: (path: string) => SceneNode | undefined;
  /** A port by its address, with its node. */
  readonly port: (address: string) => { readonly port: DrawnPort; readonly of: SceneNode } | undefined;
  /** The lines that begin at a port or node, and those that touch a node or port. */
  readonly linesFrom: (end: string) => readonly SceneLine[];
  readonly linesAt: (end: string) => readonly SceneLine[];
  /** The ports that lead to a barrier. */
  readonly inbound: (path: string) => readonly string[];
}

/** What is painted around a box: outlines and the note of a barrier. */
const kAround = 24;

function around(boxes: readonly Box[]): Box {
  const left = Math.min(...boxes.map(({ x }) => x)) - kAround;
  const top = Math.min(...boxes.map(({ y }) => y)) - kAround;
  const right = Math.max(...boxes.map(({ x, width }) => x + width)) + kAround;
  const bottom = Math.max(...boxes.map(({ y, height }) => y + height)) + kAround;
  return { x: left, y: top, width: right - left, height: bottom - top };
}

const parentPath = (path: string): string => path.slice(0, Math.max(0, path.lastIndexOf("/")));

function put<T>(table: Map<string, T[]>, key: string, item: T): void {
  const known = table.get(key);
  if (known === undefined) table.set(key, [item]);
  else known.push(item);
}

export function sceneOf(drawing: Drawing, tree: ModelTree): Scene {
  const drawn = new Map(drawing.nodes.map((node) => [node.path, node]));
  const nodes = drawing.nodes.map((node): SceneNode => ({ kind: "node", node, inside: drawn.get(parentPath(node.path)), order: node.depth * 2, ...around([node, ...node.ports]) }));
  const lines = flowLines(drawing).map(({ line, source, zIndex }): SceneLine => {
    const inside = line.kind === "first" ? drawn.get(line.from) : drawn.get(parentPath(source));
    return { kind: "line", line, inside, order: zIndex, ...around(line.points.map((point) => ({ ...point, width: 0, height: 0 }))) };
  });
  const byPath = new Map(nodes.map((node) => [node.node.path, node]));
  const from = new Map<string, SceneLine[]>();
  const at = new Map<string, SceneLine[]>();
  for (const item of lines) {
    put(from, item.line.from, item);
    for (const end of new Set([item.line.from, splitAddress(item.line.from)?.path, item.line.to])) if (end !== undefined) put(at, end, item);
  }
  const port = (address: string) => {
    const of = byPath.get(splitAddress(address)?.path ?? "");
    const found = of?.node.ports.find((each) => each.address === address);
    return of === undefined || found === undefined ? undefined : { port: found, of };
  };
  const items: readonly SceneItem[] = [...nodes, ...lines].sort((a, b) => a.order - b.order);
  return {
    drawing,
    items: spatialIndex(items),
    node: (path) => byPath.get(path),
    port,
    linesFrom: (end) => from.get(end) ?? [],
    linesAt: (end) => at.get(end) ?? [],
    inbound: (path) => inboundPorts(tree, path),
  };
}
