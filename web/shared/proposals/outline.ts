// What a proposal changes, in rows: of a document that is there, how the two differ; of a new one, the states that it has.
import { compare } from "../edit/difference/compare";
import { elementText, type DifferenceRow } from "../edit/difference/rows";
import type { Tree } from "../edit/tree";

export interface Outline {
  /** Nothing, if it is a new document. */
  readonly before: Tree | undefined;
  readonly after: Tree;
  readonly rows: readonly DifferenceRow[];
  /** Places or notes are not the same, either. */
  readonly inDrawing: boolean;
}

/** `before`: nothing, if it is a new document. */
export function outlineOf(before: Tree | undefined, after: Tree): Outline {
  if (before !== undefined) return compare(before, after);
  const nodes = [...after.elements.values()].filter(({ kind }) => kind === "state" || kind === "barrier");
  return { before, after, rows: nodes.map(({ id }) => ({ kind: "added", id, name: elementText(after, id), text: "" })), inDrawing: false };
}
