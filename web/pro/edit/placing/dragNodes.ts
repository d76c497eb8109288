// Dragging states in the drawing places them: lines follow, the document changes once, where they are dropped. Esc gives it up.
import { mover } from "../../../shared/drawing/moved";
import type { Point } from "../../../shared/drawing/drawing";
import { moveNodes, wayOnGrid } from "../../../shared/edit/commands/placing";
import { nameOf } from "../../../shared/model/modelTree";
import { selectedPaths } from "../../../shared/session/view";
import type { CanvasView } from "../../canvas/canvasView";
import { isPreview, showPreview } from "../../canvas/placingPreview";
import { view } from "../../client";
import { refusalNow } from "../../login/rights";
import { carryOut } from "../carryOut";
import { followPointer, type Drag, type Held } from "../gestures/drag";
import type { ScreenPoint } from "../prompt";
import { editedPlaces } from "./editedPlaces";

const parentOf = (path: string): string => path.slice(0, path.length - nameOf(path).length - 1);

/** What a press on the node at `path` would move: it, or all that are selected in its level. */
function draggedWith(path: string): readonly string[] {
  const selected = selectedPaths(view.get());
  return selected.includes(path) ? selected.filter((each) => parentOf(each) === parentOf(path)) : [path];
}

/** The state that a press would move. A barrier needs Ctrl, as a line is led from it; the outermost state moves the drawing. */
function pressedNode(canvas: CanvasView, event: PointerEvent): string | undefined {
  if (event.button !== 0 || event.shiftKey || event.defaultPrevented || event.pointerType === "touch") return undefined;
  if (!(event.target instanceof Element) || event.target.closest(".state-toggle, .react-flow__controls, .react-flow__minimap, .note, .comment-mark") !== null) return undefined;
  const hit = canvas.nodeAt({ x: event.clientX, y: event.clientY });
  if (hit === undefined || hit.port !== undefined || hit.path === canvas.laid.drawing.nodes[0]?.path) return undefined;
  return canvas.laid.tree.get(hit.path)?.node.kind === "barrier" && !event.ctrlKey ? undefined : hit.path;
}

/** What moves with the pointer: onto the grid, but for Alt. It is shown where it would be dropped. */
function dragOf(canvas: CanvasView, pressed: string, from: ScreenPoint): Drag {
  const { laid } = canvas;
  const paths = draggedWith(pressed);
  const moved = mover(laid.drawing, paths);
  let frame = 0;
  const byOf = ({ x, y }: ScreenPoint, { altKey }: Held): Point => {
    const { zoom } = canvas.viewport();
    const by = { x: (x - from.x) / zoom, y: (y - from.y) / zoom };
    return altKey ? by : wayOnGrid(laid.drawing, laid.tree, pressed, by);
  };
  const show = (by: Point): void => showPreview(laid, { ...laid, drawing: moved(by) });
  if (!selectedPaths(view.get()).includes(pressed)) view.dispatch({ type: "select", selection: { kind: "node", path: pressed } });
  return {
    move: (at, held) => {
      cancelAnimationFrame(frame);
      frame = requestAnimationFrame(() => show(byOf(at, held)));
    },
    drop: (at, held) => {
      const by = byOf(at, held);
      show(by);
      const before = editedPlaces();
      carryOut(moveNodes(laid.drawing, laid.tree, paths, by));
      if (editedPlaces() === before) showPreview(laid, undefined);
    },
    end: () => {
      cancelAnimationFrame(frame);
      showPreview(laid, undefined);
    },
  };
}

/** To be called for each press on the canvas. */
export function dragFrom(canvas: CanvasView, press: PointerEvent): void {
  const pressed = pressedNode(canvas, press);
  if (pressed === undefined || isPreview(canvas.laid) || refusalNow("edit") !== undefined) return;
  press.preventDefault();
  followPointer(press, () => dragOf(canvas, pressed, { x: press.clientX, y: press.clientY }));
}
