// Carrying commands about comments out, as the person at this page, now.
import type { Command } from "../../shared/edit/commands/command";
import type { By } from "../../shared/edit/comments/write";
import type { Tree } from "../../shared/edit/tree";
import { newId } from "../../shared/newId";
import { carryOut } from "../edit/carryOut";
import { editedDocument } from "../edit/editing";
import { ownName } from "../presence/ownName";

export const newCommentId = (): string => newId().slice(0, 13);

const me = (): By => ({ author: ownName(), time: new Date().toISOString() });

/** The command on the document as it is now. */
export function commandNow(make: (tree: Tree, by: By) => Command): Command {
  const tree = editedDocument();
  return tree === undefined ? { reason: "the document is not here" } : make(tree, me());
}

export const carryOutNow = (make: (tree: Tree, by: By) => Command): boolean => carryOut(commandNow(make));
