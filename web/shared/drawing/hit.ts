// What of a drawing lies at a point: the port or the innermost node.
import type { DrawnNode, Drawing, Point } from "./drawing";
import { spatialIndex } from "./spatialIndex";

export interface Hit {
  readonly path: string;
  /** Address of the port at the point. */
  readonly port?: string;
}

export interface HitIndex {
  readonly at: (point: Point) => Hit | undefined;
  /** The drawn node at a path. */
  readonly node: (path: string) => DrawnNode | undefined;
}

const known = new WeakMap<Drawing, HitIndex>();

/** Made once for a drawing. Ports lie over nodes, deeper nodes over others. */
export function hitIndex(drawing: Drawing): HitIndex {
  const before = known.get(drawing);
  if (before !== undefined) return before;
  const nodes = spatialIndex(drawing.nodes);
  const ports = spatialIndex(drawing.nodes.flatMap(({ path, depth, ports }) => ports.map(({ address, x, y, width, height }) => ({ path, depth, port: address, x, y, width, height }))));
  const byPath = new Map(drawing.nodes.map((node) => [node.path, node]));
  const deepest = <T extends { readonly depth: number }>(found: readonly T[]): T | undefined => found.reduce<T | undefined>((best, each) => (best === undefined || each.depth >= best.depth ? each : best), undefined);
  const at = (point: Point): Hit | undefined => {
    const node = deepest(nodes.at(point));
    const port = deepest(ports.at(point));
    if (port !== undefined && port.depth >= (node?.depth ?? 0)) return { path: port.path, port: port.port };
    return node === undefined ? undefined : { path: node.path };
  };
  const made = { at, node: (path: string) => byPath.get(path) };
  known.set(drawing, made);
  return made;
}
