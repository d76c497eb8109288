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

/** Applies all operations in order. The path of a refusal is that of the field (`operations/2/after`). */
export function apply(tree: Tree, edit: Edit): Applied | Refusal {
  const next = new MutableTree(tree);
  const inverse: Operation[] = [];
  for (const [i, operation] of edit.operations.entries()) {
    try {
      inverse.push(applyOperation(next, operation));
    } catch (error) {
      if (error instanceof Refusal) return error.at(`operations/${i}/${error.path}`);
      throw error;
    }
  }
  const { fields, root, library, elements } = next;
  return { tree: { fields, root, library, elements }, inverse: { operations: inverse.reverse() } };
}
