// A laid out subtree, and its copy at another path.
import type { Box, DrawnLine, DrawnNode, Point } from "./drawing";
import type { Size } from "./measure";

/** Coordinates are relative to its top left corner; the first node is its root. */
export interface Block {
  readonly size: Size;
  readonly ports: readonly Box[];
  readonly nodes: readonly DrawnNode[];
  readonly lines: readonly DrawnLine[];
}

export function shift(block: Block, by: Point): Block {
  const move = <T extends Point>(item: T): T => ({ ...item, x: item.x + by.x, y: item.y + by.y });
  return {
    ...block,
    nodes: block.nodes.map((node) => ({ ...move(node), ports: node.ports.map(move) })),
    lines: block.lines.map((line) => ({ ...line, points: line.points.map(move) })),
  };
}

/** The same block at another path of the model: every path, address and id of a block begins with its root's path. */
export function rebase(block: Block, path: string, depth: number): Block {
  const root = block.nodes[0];
  if (root === undefined || (root.path === path && root.depth === depth)) return block;
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
