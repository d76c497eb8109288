// A laid out subtree, and its copy at another place or path. What is copied in the same way again is the same object, so that of a drawing in which
// one node moves all others are known.
import type { Box, DrawnLine, DrawnNode, Point } from "./drawing";
import type { Size } from "./measure";

/** Coordinates are relative to its top left corner; the first node is its root. */
export interface Block {
  readonly size: Size;
  readonly ports: readonly Box[];
  readonly nodes: readonly DrawnNode[];
  readonly lines: readonly DrawnLine[];
}

interface Shifted<T> extends Point {
  readonly made: T;
}
const shiftedNodes = new WeakMap<DrawnNode, Shifted<DrawnNode>>();
const shiftedLines = new WeakMap<DrawnLine, Shifted<DrawnLine>>();

const moved = <T extends Point>(item: T, by: Point): T => ({ ...item, x: item.x + by.x, y: item.y + by.y });

/** The last copy of an item, if it was moved by the same. */
function shifted<T extends object>(item: T, by: Point, known: WeakMap<T, Shifted<T>>, make: () => T): T {
  const last = known.get(item);
  if (last?.x === by.x && last.y === by.y) return last.made;
  const made = make();
  known.set(item, { x: by.x, y: by.y, made });
  return made;
}

export function shift(block: Block, by: Point): Block {
  return {
    ...block,
    nodes: block.nodes.map((node) => shifted(node, by, shiftedNodes, () => ({ ...moved(node, by), ports: node.ports.map((port) => moved(port, by)) }))),
    lines: block.lines.map((line) => shifted(line, by, shiftedLines, () => ({ ...line, points: line.points.map((point) => moved(point, by)) }))),
  };
}

/** Copies of a block at other paths that are kept: as many as siblings look the same. */
const kCopies = 64;
const rebased = new WeakMap<Block, Map<string, Block>>();

/** The same block at another path of the model: every path, address and id of a block begins with its root's path. */
export function rebase(block: Block, path: string, depth: number): Block {
  const root = block.nodes[0];
  if (root === undefined || (root.path === path && root.depth === depth)) return block;
  const copies = rebased.get(block) ?? new Map<string, Block>();
  rebased.set(block, copies);
  const known = copies.get(path);
  if (known?.nodes[0]?.depth === depth) return known;
  const made = copied(block, root, path, depth);
  if (copies.size >= kCopies) copies.clear();
  copies.set(path, made);
  return made;
}

function copied(block: Block, root: DrawnNode, path: string, depth: number): Block {
  const from = root.path.length;
  const deeper = depth - root.depth;
  const at = (text: string) => path + text.slice(from);
  return {
    ...block,
    nodes: block.nodes.map((node) => ({
      ...node,
      path: at(node.path),
      depth: node.depth + deeper,
      ports: node.ports.map((port) => ({ ...port, address: at(port.address) })),
    })),
    lines: block.lines.map((line) => ({
      ...line,
      id: at(line.id),
      from: at(line.from),
      to: line.to === undefined ? undefined : at(line.to),
      depth: line.depth + deeper,
    })),
  };
}
