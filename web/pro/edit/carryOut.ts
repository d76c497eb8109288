// Carrying a command out: its change is made, its refusal told, and what is new is selected.
import { isWaiting, madeBetween } from "../../shared/edit/made";
import type { Command } from "../../shared/edit/commands/command";
import type { Change } from "../../shared/edit/session";
import { selectionsOf, type Selection } from "../../shared/model/identity";
import { view } from "../client";
import { editedDocument, editedTree, editing, perform, showTop } from "./editing";
import { focusSelected } from "./gestures/focused";
import { refuse } from "./say";

/** Selects these elements where the model that is shown has them; a state of the library is shown as a whole. */
export function selectIds(ids: readonly string[]): void {
  const [first] = ids;
  if (first !== undefined && editedDocument()?.library.includes(first) === true) showTop(first);
  const model = editedTree();
  const found = model === undefined ? [] : ids.map((id) => selectionsOf(model).get(id)).filter((each): each is Selection => each !== undefined);
  const [selection] = found;
  if (selection === undefined) return;
  if (found.length === 1) view.dispatch({ type: "select", selection });
  else view.dispatch({ type: "select_all", paths: found.flatMap((each) => (each.kind === "node" ? [each.path] : [])) });
  focusSelected();
}

/** Selects what the server makes of a change, when it has. */
function selectMade(change: Change): void {
  let before = editing.get().session;
  const end = editing.listen(() => {
    const after = editing.get().session;
    const made = madeBetween(before, after, change);
    before = after;
    if (isWaiting(after, change)) return;
    end();
    if (made !== undefined && made.length > 0) selectIds(made);
  });
  if (!isWaiting(before, change)) end();
}

/** Whether there was something to carry out. */
export function carryOut(command: Command): boolean {
  if ("reason" in command) {
    refuse(command.reason);
    return false;
  }
  perform(command.change);
  if (command.select !== undefined) selectIds([command.select]);
  else if ("compound" in command.change) selectMade(command.change);
  return true;
}
