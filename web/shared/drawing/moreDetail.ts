// Whether it is worth while to lay a drawing out with more detail, from how much larger its texts become.
import { stateAt, type ModelTree } from "../model/modelTree";
import type { Drawing, DrawnNode } from "./drawing";
import { readable } from "./fit";
import { headSize, leafBoxes, type Detail, type Size } from "./measure";

/** A drawing grows less than its texts, as lines and gaps stay: by 0.6 to 1.5 times as much on the conformance models, mostly by more than this. */
const kGrowth = 0.75;
const kGap = { width: 30, height: 20 };

function textArea(node: DrawnNode, tree: ModelTree, detail: Detail): number {
  const state = stateAt(tree, node.path);
  if (state === undefined) return node.width * node.height;
  if (node.open) return node.width * headSize(state, detail).height;
  const { size } = leafBoxes(state, node.side, detail);
  return (size.width + kGap.width) * (size.height + kGap.height);
}

/** Whether the drawing of this tree, now with the detail `now`, may be readable with the detail `next` too. */
export function mayBeReadable(drawing: Drawing, tree: ModelTree, now: Detail, next: Detail, canvas: Size): boolean {
  const sum = (detail: Detail) => drawing.nodes.reduce((all, node) => all + textArea(node, tree, detail), 0);
  const larger = Math.sqrt(Math.max(1, (kGrowth * sum(next)) / sum(now)));
  return readable({ width: drawing.width * larger, height: drawing.height * larger }, canvas);
}
