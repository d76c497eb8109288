// How two documents differ, as the page shows it: in a list, and in the drawing.
import type { Tree } from "../tree";
import { difference } from "./difference";
import { differenceRows, differsInDrawing, type DifferenceRow } from "./rows";

export interface Compared {
  readonly before: Tree;
  readonly after: Tree;
  readonly rows: readonly DifferenceRow[];
  /** Places or notes are not the same, either. */
  readonly inDrawing: boolean;
}

let last: Compared | undefined;

/** How two documents differ. What was compared last is not compared again. */
export function compare(before: Tree, after: Tree): Compared {
  if (last?.before === before && last.after === after) return last;
  const found = difference(before, after);
  last = { before, after, rows: differenceRows(before, after, found), inDrawing: differsInDrawing(found) };
  return last;
}
