// Cache of layouts: subtrees that look the same (states linked twice, a task that is drawn again with one state
// more open) are laid out once. A look is the key: all that a layout depends on, without paths and ids.
import { childPath, keyOf, type Node } from "../model/model";
import type { Block } from "./block";
import type { Side } from "./drawing";
import { drawnLines, type Detail } from "./measure";
import { kNoPlaces, placeOfChild, type Places } from "./places";

/** Capacity: blocks, and words (most are of states without children). A table that is full is cleared. */
const kMost = { blocks: 2000, words: 20_000 };

/** How a subtree is to be drawn; one object for one drawing. */
export interface LookRequest {
  readonly collapsed: ReadonlySet<string>;
  readonly detail: Detail;
  readonly aspect: number;
  readonly places?: Places;
}

export interface LayoutCache {
  /** The key of a subtree. Subtrees that look different never have the same key; the same look has the same key until the table is cleared.
   *  Rows are wrapped on so many `levels`, from the subtree's own down. */
  readonly look: (node: Node, path: string, side: Side, levels: number, request: LookRequest) => string;
  readonly find: (look: string) => Block | undefined;
  readonly keep: (look: string, block: Block) => void;
}

export function layoutCache(most = kMost): LayoutCache {
  const words = new Map<string, number>();
  const blocks = new Map<string, Block>();
  let latest = 0;
  const word = (parts: unknown): number => {
    const text = JSON.stringify(parts);
    const known = words.get(text);
    if (known !== undefined) return known;
    if (words.size >= most.words) words.clear();
    words.set(text, ++latest);
    return latest;
  };
  // Memoized: a subtree is a part of the key of each of its ancestors.
  const shapes = new WeakMap<LookRequest, Map<string, number>>();
  const shape = (node: Node, path: string, request: LookRequest): number => {
    const known = shapes.get(request) ?? new Map<string, number>();
    shapes.set(request, known);
    const found = known.get(path) ?? shapeOf(node, path, request);
    known.set(path, found);
    return found;
  };
  const shapeOf = (node: Node, path: string, request: LookRequest): number => {
    if (node.kind === "barrier") return word([node.name, keyOf(node), node.to]);
    const { collapsed, detail, aspect, places = kNoPlaces } = request;
    const open = node.children.length > 0 && !collapsed.has(path);
    const children = open ? node.children.map((child) => shape(child, childPath(path, child), request)) : node.children.length > 0;
    const placed = open && places.size > 0 ? node.children.map((child) => placeOfChild(places, node, child)).map((place) => place && [place.x, place.y, place.side]) : [];
    const ports = node.ports.map((port) => [port.name, keyOf(port), port.when, port.after, port.to]);
    return word([node.name, keyOf(node), node.first, node.link, node.oracle, node.dispatcher, node.parameters.map(({ from }) => from), ports, children, detail, drawnLines(node, detail), open ? aspect : 0, placed.some((place) => place !== undefined) ? placed : 0]);
  };
  return {
    look: (node, path, side, levels, request) => `${side} ${levels} ${shape(node, path, request)}`,
    find: (look) => blocks.get(look),
    keep: (look, block) => {
      if (blocks.size >= most.blocks) blocks.clear();
      blocks.set(look, block);
    },
  };
}
