// Dragging states in the drawing places them: lines follow, the document changes once, where they are dropped. Esc gives it up.
import { movedDrawing } from "../../../shared/drawing/moved";
import type { Point } from "../../../shared/drawing/drawing";
import { kGrid, moveNodes } from "../../../shared/edit/commands/placing";
import { nameOf } from "../../../shared/model/modelTree";
import { selectedPaths } from "../../../shared/session/view";
import type { CanvasView } from "../../canvas/canvasView";
import { isPreview, showPreview } from "../../canvas/placingPreview";
import { view } from "../../client";
import { editedPlaces } from "./editedPlaces";
import { carryOut } from "./carryOut";

/** A press with less of a move is a click [px]. */
const kThreshold = 4;

const parentOf = (path: string): string => path.slice(0, path.length - nameOf(path).length - 1);

/** What a press on the node at `path` would move: it, or all that are selected in its level. */
function draggedWith(path: string): readonly string[] {
  const selected = selectedPaths(view.get());
  return selected.includes(path) ? selected.filter((each) => parentOf(each) === parentOf(path)) : [path];
}

/** The state that a press would move. A barrier needs Ctrl, as a line is led from it; the outermost state moves the drawing. */
function pressedNode(canvas: CanvasView, event: PointerEvent): string | undefined {
  if (event.button !== 0 || event.shiftKey || event.defaultPrevented || event.pointerType === "touch") return undefined;
  if (!(event.target instanceof Element) || event.target.closest(".state-toggle, .react-flow__controls, .react-flow__minimap, .note") !== null) return undefined;
  const hit = canvas.nodeAt({ x: event.clientX, y: event.clientY });
  if (hit === undefined || hit.port !== undefined || hit.path === canvas.laid.drawing.nodes[0]?.path) return undefined;
  return canvas.laid.tree.get(hit.path)?.node.kind === "barrier" && !event.ctrlKey ? undefined : hit.path;
}

/** The click that follows a drag is none. */
function swallowClick(): void {
  const swallow = (event: MouseEvent) => event.stopPropagation();
  addEventListener("click", swallow, { capture: true, once: true });
  setTimeout(() => removeEventListener("click", swallow, true));
}

/** To be called for each press on the canvas. */
export function dragFrom(canvas: CanvasView, press: PointerEvent): void {
  const pressed = pressedNode(canvas, press);
  const { laid } = canvas;
  if (pressed === undefined || isPreview(laid)) return;
  press.preventDefault();
  let paths: readonly string[] | undefined;
  let frame = 0;
  const stop = new AbortController();
  const byOf = ({ clientX, clientY }: MouseEvent): Point => {
    const { zoom } = canvas.viewport();
    return { x: (clientX - press.clientX) / zoom, y: (clientY - press.clientY) / zoom };
  };
  const end = () => {
    stop.abort();
    cancelAnimationFrame(frame);
  };
  const cancel = () => {
    end();
    showPreview(laid, undefined);
  };
  const move = (event: PointerEvent) => {
    if (event.pointerId !== press.pointerId) return;
    if (paths === undefined && Math.hypot(event.clientX - press.clientX, event.clientY - press.clientY) < kThreshold) return;
    const dragged = (paths ??= draggedWith(pressed));
    if (!selectedPaths(view.get()).includes(pressed)) view.dispatch({ type: "select", selection: { kind: "node", path: pressed } });
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(() => showPreview(laid, { ...laid, drawing: movedDrawing(laid.drawing, dragged, byOf(event)) }));
  };
  const drop = (event: PointerEvent) => {
    if (event.pointerId !== press.pointerId) return;
    end();
    if (paths === undefined) return;
    swallowClick();
    showPreview(laid, { ...laid, drawing: movedDrawing(laid.drawing, paths, byOf(event)) });
    const before = editedPlaces();
    carryOut(moveNodes(laid.drawing, laid.tree, paths, byOf(event), event.altKey ? 1 : kGrid));
    if (editedPlaces() === before) showPreview(laid, undefined);
  };
  const key = (event: KeyboardEvent) => {
    if (event.key !== "Escape" || paths === undefined) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    cancel();
  };
  const { signal } = stop;
  addEventListener("pointermove", move, { signal });
  addEventListener("pointerup", drop, { signal });
  addEventListener("pointercancel", cancel, { signal });
  addEventListener("blur", cancel, { signal });
  addEventListener("keydown", key, { capture: true, signal });
}
