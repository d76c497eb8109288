// Layouts that are known: of subtrees that look the same (states linked twice, a task that is drawn again with one state
// more open) only one is laid out. A look is what a layout depends on, whatever the path.
import type { Node } from "../model/model";
import type { Block } from "./block";
import type { Side } from "./drawing";
import { drawnLines, type Detail } from "./measure";

/** So many are kept; then it begins anew. */
const kMost = 2000;

/** How a subtree is to be drawn; one object for one drawing. */
export interface LookRequest {
  readonly collapsed: ReadonlySet<string>;
  readonly detail: Detail;
  readonly aspect: number;
}

export interface LayoutMemory {
  /** The same word for subtrees that look the same. */
  readonly look: (node: Node, path: string, side: Side, request: LookRequest) => string;
  /** What was laid out as thoroughly as this, or more so. */
  readonly find: (look: string, thorough: boolean) => Block | undefined;
  readonly keep: (look: string, thorough: boolean, block: Block) => void;
}

export function layoutMemory(): LayoutMemory {
  const words = new Map<string, number>();
  const blocks = new Map<string, Block>();
  const rough = new Map<string, Block>();
  const word = (parts: unknown): number => {
    const text = JSON.stringify(parts);
    const known = words.get(text) ?? words.size;
    words.set(text, known);
    return known;
  };
  // A subtree is a part of all above it: without this it would be read as often.
  const shapes = new WeakMap<LookRequest, Map<string, number>>();
  const shape = (node: Node, path: string, request: LookRequest): number => {
    const known = shapes.get(request) ?? new Map<string, number>();
    shapes.set(request, known);
    const found = known.get(path) ?? shapeOf(node, path, request);
    known.set(path, found);
    return found;
  };
  const shapeOf = (node: Node, path: string, request: LookRequest): number => {
    if (node.kind === "barrier") return word(node);
    const { collapsed, detail, aspect } = request;
    const open = node.children.length > 0 && !collapsed.has(path);
    const children = open ? node.children.map((child) => shape(child, `${path}/${child.name}`, request)) : node.children.length > 0;
    return word([node.name, node.first, node.link, node.oracle, node.dispatcher, node.parameters.map(({ from }) => from), node.ports, children, detail, drawnLines(node, detail), open ? aspect : 0]);
  };
  return {
    look: (node, path, side, request) => `${side} ${shape(node, path, request)}`,
    find: (look, thorough) => blocks.get(look) ?? (thorough ? undefined : rough.get(look)),
    keep: (look, thorough, block) => {
      const kept = thorough ? blocks : rough;
      if (kept.size >= kMost) kept.clear();
      kept.set(look, block);
    },
  };
}
