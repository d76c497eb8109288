// The drawing of the document that is edited, with what the pointer does on it.
import { useRef, type MouseEvent, type PointerEvent, type ReactNode, type TouchEvent } from "react";
import type { Selection } from "../../../shared/model/identity";
import { selectedPaths } from "../../../shared/session/view";
import { view } from "../../client";
import { openMenu } from "../actions/menuAction";
import { actions, actionOf } from "../actions/registry";
import { runAction } from "../actions/action";
import { isPrompting, kCanvasId } from "../prompt";
import { situationNow } from "../situation";
import { bandFrom } from "./band";
import { followPointer } from "./drag";
import { canvasElement, hitAt, isOnDrawing } from "./onScreen";
import { wireFrom } from "./wire";

interface Props {
  /** The name of the document. */
  readonly document: string | undefined;
  readonly children: ReactNode;
}

const pointOf = ({ clientX, clientY }: MouseEvent) => ({ x: clientX, y: clientY });
const isAlso = ({ ctrlKey, metaKey, shiftKey }: MouseEvent) => ctrlKey || metaKey || shiftKey;
const focusCanvas = () => canvasElement()?.focus({ preventScroll: true });

function isSelected(hit: Selection): boolean {
  const now = view.get();
  return hit.kind === "node" ? selectedPaths(now).includes(hit.path) : now.selection?.kind === "port" && now.selection.address === hit.address;
}

/** A click with Ctrl or Shift selects besides. */
function click(event: MouseEvent): void {
  const hit = isOnDrawing(pointOf(event)) ? hitAt(pointOf(event)) : undefined;
  if (!isAlso(event) || hit?.kind !== "node") return;
  event.stopPropagation();
  focusCanvas();
  view.dispatch({ type: "select_also", path: hit.path });
}

/** A double click shows the properties, of a state in the state editor; with Ctrl it enters. */
function doubleClick(event: MouseEvent): void {
  const hit = isOnDrawing(pointOf(event)) ? hitAt(pointOf(event)) : undefined;
  if (hit === undefined) return;
  event.stopPropagation();
  view.dispatch({ type: "select", selection: hit });
  runAction(actionOf(event.ctrlKey || event.metaKey ? "enter" : hit.kind === "node" ? "state_editor" : "properties"));
}

function openContextMenu(event: MouseEvent): void {
  event.preventDefault();
  if (isPrompting()) return;
  const hit = hitAt(pointOf(event));
  if (hit === undefined || !isSelected(hit)) view.dispatch({ type: "select", selection: hit });
  focusCanvas();
  const situation = situationNow();
  if (situation !== undefined) openMenu(actions, situation, pointOf(event));
}

export function EditCanvas({ document, children }: Props) {
  const draggingRef = useRef(false);
  const press = (event: PointerEvent) => {
    draggingRef.current = false;
    const at = pointOf(event);
    if (event.button !== 0 || !isOnDrawing(at)) return;
    focusCanvas();
    const hit = hitAt(at);
    const wires = !isAlso(event) && hit !== undefined && wireFrom(hit) !== undefined;
    if (!wires && !event.shiftKey) return;
    draggingRef.current = true;
    event.preventDefault();
    followPointer(event, () => (wires ? wireFrom(hit) : bandFrom(at)));
  };
  // A drag of ours does not move the drawing.
  const keepDrawing = (event: MouseEvent | TouchEvent) => draggingRef.current && event.stopPropagation();
  // The drawing as a whole has the focus: what is in it may be drawn anew.
  const keepFocus = (event: MouseEvent) => {
    if (isOnDrawing(pointOf(event))) event.preventDefault();
    keepDrawing(event);
  };
  return (
    <div
      id={kCanvasId}
      className="edit-canvas"
      tabIndex={0}
      role="application"
      aria-label={`Drawing of ${document ?? "no document"}`}
      onPointerDownCapture={press}
      onMouseDownCapture={keepFocus}
      onTouchStartCapture={keepDrawing}
      onClickCapture={click}
      onDoubleClickCapture={doubleClick}
      onContextMenu={openContextMenu}
    >
      {children}
    </div>
  );
}
