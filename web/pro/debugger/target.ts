// What the debugger's commands are about: the selected state or port of the model that is shown, on the page of the run or of the document.
import { whereOf } from "../../shared/debugger/places";
import type { Where } from "../../shared/debugger/breakpoints";
import { idAt, selectionsOf, type Selection } from "../../shared/model/identity";
import { nameOf, portAt, stateAt, type ModelTree } from "../../shared/model/modelTree";
import { shownCanvas } from "../canvas/canvasView";
import { useView, view } from "../client";
import { editedTree, useEditedTree } from "../edit/editing";
import type { ScreenPoint } from "../edit/prompt";
import { runTree, useRunTree } from "../live/runTree";

/** The model that is shown. */
export const shownTree = (): ModelTree | undefined => (view.get().page === "edit" ? editedTree() : runTree());

/** The same, for components. */
export function useShownTree(): ModelTree | undefined {
  const isEdited = useView((v) => v.page === "edit");
  const [edited, run] = [useEditedTree(), useRunTree()];
  return isEdited ? edited : run;
}

export interface Target {
  readonly tree: ModelTree;
  readonly selection: Selection;
  readonly where: Where;
  readonly kind: "state" | "port";
  readonly name: string;
}

/** A selected state or port as a target; nothing: none is selected alone. */
export function targetOf(tree: ModelTree | undefined, selection: Selection | undefined): Target | undefined {
  if (tree === undefined || selection === undefined) return undefined;
  const isThere = selection.kind === "port" ? portAt(tree, selection.address) !== undefined : stateAt(tree, selection.path) !== undefined;
  if (!isThere) return undefined;
  return { tree, selection, where: whereOf(tree, selection), kind: selection.kind === "port" ? "port" : "state", name: nameOf(selection.kind === "port" ? selection.address : selection.path) };
}

export const targetNow = (): Target | undefined => targetOf(shownTree(), view.get().also.size > 0 ? undefined : view.get().selection);

/** Where the model of the watched run has what is selected. */
export function selectionInRun(): Selection | undefined {
  const [{ page, selection }, run] = [view.get(), runTree()];
  const edited = page === "edit" ? editedTree() : undefined;
  if (page !== "edit" || selection === undefined || run === undefined) return page === "edit" ? undefined : selection;
  const id = edited && idAt(edited, selection);
  return id === undefined ? undefined : selectionsOf(run).get(id);
}

/** Where on the screen to ask about what is selected: at the row or drawing of it, else in the middle of the page. */
export function placeOnScreen(): ScreenPoint {
  const selection = view.get().selection;
  const address = selection?.kind === "port" ? selection.address : selection?.path;
  const row = document.activeElement?.closest('[role="tree"]')?.querySelector(`[data-path="${CSS.escape(address ?? "")}"]`)?.getBoundingClientRect();
  if (row !== undefined) return { x: row.left, y: row.bottom };
  const canvas = shownCanvas();
  const node = canvas?.laid.drawing.nodes.find(({ path, ports }) => path === address || ports.some((port) => port.address === address));
  const box = node?.ports.find((port) => port.address === address) ?? node;
  return box === undefined || canvas === undefined ? { x: innerWidth / 3, y: innerHeight / 3 } : canvas.toScreen({ x: box.x, y: box.y + box.height });
}
