// What stands folded at first: a large task is shown by its first level, so that it is drawn at once and can be read.
import type { ModelTree } from "./modelTree";

/** So many nodes are drawn whole. */
const kWhole = 60;

/** Composites below the root that are folded when a model is first shown. */
export function foldedAtFirst(tree: ModelTree): readonly string[] {
  if (tree.size <= kWhole) return [];
  return [...tree.values()].filter((entry) => entry.depth > 0 && entry.children.length > 0).map((entry) => entry.path);
}
