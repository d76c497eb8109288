// Selects an element of the document that is edited, by its id; of what has no place in the drawing, the state that has it.
import { selectionsOf } from "../../../shared/model/identity";
import { view } from "../../client";
import { editedDocument, editedTree, showTop } from "../editing";

/** The state of the library, or the root, in which an element stands. */
function topOfElement(id: string): string | undefined {
  const tree = editedDocument();
  let at = tree?.elements.get(id);
  while (at !== undefined && at.parent !== "") at = tree?.elements.get(at.parent);
  return at?.id;
}

export function selectById(id: string): void {
  const tree = editedDocument();
  const element = tree?.elements.get(id);
  if (tree === undefined || element === undefined) return;
  let shown = editedTree();
  const owner = element.kind === "state" || element.kind === "barrier" || element.kind === "port" ? id : element.parent;
  if (shown !== undefined && !selectionsOf(shown).has(owner)) {
    showTop(topOfElement(id));
    shown = editedTree();
  }
  const selection = shown && selectionsOf(shown).get(owner);
  if (selection !== undefined) view.dispatch({ type: "jump", selection });
}
