// The element of the model that has the focus, and the one that is selected: keys are for the first, so they are made one.
import type { Selection } from "../../../shared/model/identity";
import { selectedPaths } from "../../../shared/session/view";
import { view } from "../../client";
import { canvasElement } from "./onScreen";

/** The node or port whose button or row has the focus. */
function focused(): Selection | undefined {
  const found = document.activeElement?.closest<HTMLElement>("[data-address], [data-path]");
  const { address, path } = found?.dataset ?? {};
  if (address !== undefined) return { kind: "port", address };
  return path === undefined ? undefined : { kind: "node", path };
}

function isSelected(selection: Selection): boolean {
  const now = view.get();
  return selection.kind === "node" ? selectedPaths(now).includes(selection.path) : now.selection?.kind === "port" && now.selection.address === selection.address;
}

/** Selects what has the focus, if it is not selected. */
export function takeFocused(): void {
  const selection = focused();
  if (selection !== undefined && !isSelected(selection)) view.dispatch({ type: "select", selection });
}

const rowOf = (path: string): HTMLElement | null => document.querySelector(`[role="tree"] [data-path="${CSS.escape(path)}"] .tree-name`);

/** Moves the focus along with what is selected: to its row if the tree has it, else to the drawing as a whole. In a panel it stays. */
export function focusSelected(): void {
  const { selection } = view.get();
  const at = document.activeElement;
  if (at !== null && at !== document.body && at.closest('#edit-canvas, [role="tree"]') === null) return;
  const inTree = document.activeElement?.closest('[role="tree"]') != null;
  const row = inTree && selection?.kind === "node" ? rowOf(selection.path) : null;
  (row ?? canvasElement())?.focus({ preventScroll: true });
}
