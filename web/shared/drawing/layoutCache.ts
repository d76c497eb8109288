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

/** All that a layout depends on of the node alone. */
function ownLook(node: Node, detail: Detail): readonly unknown[] {
  if (node.kind === "barrier") return [node.name, keyOf(node), node.to];
  const ports = node.ports.map((port) => [port.name, keyOf(port), port.when, port.after, port.to]);
  return [node.name, keyOf(node), node.first, node.link, node.oracle, node.dispatcher, node.parameters.map(({ from }) => from), ports, detail, drawnLines(node, detail)];
}

export function layoutCache(most = kMost): LayoutCache {
  const words = new Map<string, number>();
  const blocks = new Map<string, Block>();
  /** What nodes say themselves, in each detail: an edit makes anew only the nodes that it changes. */
  let own = new WeakMap<Node, Map<Detail, number>>();
  let latest = 0;
  const word = (parts: unknown): number => {
    const text = JSON.stringify(parts);
    const known = words.get(text);
    if (known !== undefined) return known;
    if (words.size >= most.words) {
      words.clear();
      own = new WeakMap();
    }
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
  const ownWord = (node: Node, detail: Detail): number => {
    const known = own.get(node)?.get(detail);
    if (known !== undefined) return known;
    const made = word(ownLook(node, detail));
    // Not before: the table may have been cleared.
    own.set(node, (own.get(node) ?? new Map<Detail, number>()).set(detail, made));
    return made;
  };
  const shapeOf = (node: Node, path: string, request: LookRequest): number => {
    if (node.kind === "barrier" || node.children.length === 0) return ownWord(node, request.detail);
    const { collapsed, detail, aspect, places = kNoPlaces } = request;
    if (collapsed.has(path)) return word([ownWord(node, detail), true]);
    const children = node.children.map((child) => shape(child, childPath(path, child), request));
    const placed = places.size > 0 ? node.children.map((child) => placeOfChild(places, node, child)).map((place) => place && [place.x, place.y, place.side]) : [];
    return word([ownWord(node, detail), children, aspect, placed.some((place) => place !== undefined) ? placed : 0]);
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
