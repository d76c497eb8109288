// Applying edits to trees: as a whole or not at all (core/edit/apply.h). What the server alone decides: whether the text of the document
// becomes too large, and what an edit means that was made on an earlier revision.
import type { Edit } from "../../generated/messages";
import { assertNever } from "../assertNever";
import { MutableTree } from "./mutableTree";
import { Refusal } from "./refusal";
import type { Tree } from "./tree";

export type Operation = Edit["operations"][number];

export interface Applied {
  readonly tree: Tree;
  /** Takes the edit back. */
  readonly inverse: Edit;
}

function applyOperation(tree: MutableTree, operation: Operation): Operation {
  switch (operation.op) {
    case "insert":
      return tree.insert(operation);
    case "remove":
      return tree.remove(operation);
    case "move":
      return tree.move(operation);
    case "set":
      return tree.set(operation);
    default:
      return assertNever(operation);
  }
}

const finished = ({ fields, root, library, elements }: MutableTree): Tree => ({ fields, root, library, elements });

/** The operations that take it back. If one is refused, those before it are done. */
function applyTo(next: MutableTree, edit: Edit): readonly Operation[] | Refusal {
  const inverse: Operation[] = [];
  for (const [i, operation] of edit.operations.entries()) {
    try {
      inverse.push(applyOperation(next, operation));
    } catch (error) {
      if (error instanceof Refusal) return error.at(`operations/${i}/${error.path}`);
      throw error;
    }
  }
  return inverse.reverse();
}

/** Applies all operations in order. The path of a refusal is that of the field (`operations/2/after`). */
export function apply(tree: Tree, edit: Edit): Applied | Refusal {
  const next = new MutableTree(tree);
  const inverse = applyTo(next, edit);
  return inverse instanceof Refusal ? inverse : { tree: finished(next), inverse: { operations: inverse } };
}

/** The tree after edits, one after the other; those that are refused then are left out. A tree is copied once, not for each edit. */
export function applyFitting(tree: Tree, edits: readonly Edit[]): Tree {
  for (let fitting = edits; fitting.length > 0; ) {
    const next = new MutableTree(tree);
    const refused = fitting.findIndex((edit) => applyTo(next, edit) instanceof Refusal);
    if (refused === -1) return finished(next);
    fitting = fitting.filter((_, i) => i !== refused);
  }
  return tree;
}
