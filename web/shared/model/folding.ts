// The initial folding: of a large task only the first level is shown, so that it is drawn fast and readable.
import type { ModelTree } from "./modelTree";

/** Models with more nodes are folded. */
const kWhole = 60;

/** Composites below the root that are folded when a model is first shown. */
export function foldedAtFirst(tree: ModelTree): readonly string[] {
  if (tree.size <= kWhole) return [];
  return [...tree.values()].filter((entry) => entry.depth > 0 && entry.children.length > 0).map((entry) => entry.path);
}
