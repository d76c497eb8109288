// Turning to what a row, an error or an obstacle is about: in the document that is edited, else in the run.
import { selectionsOf } from "../../shared/model/identity";
import { selectionAt, type Selection } from "../../shared/session/view";
import { view } from "../client";
import { editedTree } from "../edit/editing";
import { runTree } from "./runTree";

/** Where an element of the run is in the document that is edited, if that has it. */
export function inEdited(id: string | undefined): Selection | undefined {
  const tree = editedTree();
  return id === undefined || tree === undefined ? undefined : selectionsOf(tree).get(id);
}

/** Where the model of the run has this node or port. */
export function inRun(address: string): Selection | undefined {
  const tree = runTree();
  return tree && selectionAt(tree, address);
}

/** Shows a place of the run, on the page of the run. */
export function showInRun(selection: Selection): void {
  view.dispatch({ type: "page", page: "task" });
  view.dispatch({ type: "jump", selection });
}
