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

function around(first: Box, others: readonly Box[]): Box {
  let [left, top, right, bottom] = [first.x, first.y, first.x + first.width, first.y + first.height];
  for (const { x, y, width, height } of others) {
    left = Math.min(left, x);
    top = Math.min(top, y);
    right = Math.max(right, x + width);
    bottom = Math.max(bottom, y + height);
  }
  return { x: left - kAround, y: top - kAround, width: right - left + 2 * kAround, height: bottom - top + 2 * kAround };
}

const parentPath = (path: string): string => path.slice(0, Math.max(0, path.lastIndexOf("/")));

function put<T>(table: Map<string, T[]>, key: string, item: T): void {
  const known = table.get(key);
  if (known === undefined) table.set(key, [item]);
  else known.push(item);
}

const kNowhere: Box = { x: 0, y: 0, width: 0, height: 0 };
const itemsOfNodes = new WeakMap<DrawnNode, SceneNode>();
const itemsOfLines = new WeakMap<DrawnLine, SceneLine>();

/** The same item for the same node in the same composite: of a drawing in which one node moves, all others are known. */
function nodeItem(node: DrawnNode, inside: DrawnNode | undefined): SceneNode {
  const known = itemsOfNodes.get(node);
  if (known !== undefined && known.inside === inside) return known;
  const made: SceneNode = { kind: "node", node, inside, order: node.depth * 2, ...around(node, node.ports) };
  itemsOfNodes.set(node, made);
  return made;
}

function lineItem(line: DrawnLine, inside: DrawnNode | undefined, order: number): SceneLine {
  const known = itemsOfLines.get(line);
  if (known !== undefined && known.inside === inside) return known;
  const [first = kNowhere, ...rest] = line.points.map((point) => ({ ...point, width: 0, height: 0 }));
  const made: SceneLine = { kind: "line", line, inside, order, ...around(first, rest) };
  itemsOfLines.set(line, made);
  return made;
}

/** What `make` makes, when it is asked for the first time. */
function later<T>(make: () => T): () => T {
  let made: { readonly value: T } | undefined;
  return () => (made ??= { value: make() }).value;
}

export function sceneOf(drawing: Drawing, tree: ModelTree): Scene {
  const drawn = new Map(drawing.nodes.map((node) => [node.path, node]));
  const nodes = drawing.nodes.map((node) => nodeItem(node, drawn.get(parentPath(node.path))));
  const lines = flowLines(drawing).map(({ line, source, zIndex }) => lineItem(line, line.kind === "first" ? drawn.get(line.from) : drawn.get(parentPath(source)), zIndex));
  const byPath = new Map(nodes.map((node) => [node.node.path, node]));
  const from = later(() => {
    const table = new Map<string, SceneLine[]>();
    for (const item of lines) put(table, item.line.from, item);
    return table;
  });
  const touches = ({ from: source, to }: DrawnLine, end: string) => source === end || to === end || splitAddress(source)?.path === end;
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
    linesFrom: (end) => from().get(end) ?? [],
    linesAt: (end) => lines.filter(({ line }) => touches(line, end)),
    inbound: (path) => inboundPorts(tree, path),
  };
}
