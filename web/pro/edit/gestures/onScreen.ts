// Where things of the drawing are on the screen, and what is at a point of it. The drawing may be of the model before the latest edit: what it
// says is of elements by their ids, so it holds for the model as it is now, too.
import type { Box } from "../../../shared/drawing/drawing";
import { carried, selectionsOf, type Selection } from "../../../shared/model/identity";
import { splitAddress } from "../../../shared/model/modelTree";
import { selectedPaths } from "../../../shared/session/view";
import { shownCanvas, type CanvasView } from "../../canvas/canvasView";
import { view } from "../../client";
import { editedTree } from "../editing";
import { kCanvasId, type ScreenPoint } from "../prompt";

export const canvasElement = (): HTMLElement | null => document.getElementById(kCanvasId);

function onScreen({ toScreen }: CanvasView, { x, y, width, height }: Box): DOMRect {
  const [from, to] = [toScreen({ x, y }), toScreen({ x: x + width, y: y + height })];
  return new DOMRect(from.x, from.y, to.x - from.x, to.y - from.y);
}

/** The place of a node or port of the model on the screen; nothing: it is not drawn. */
export function boxOf(selection: Selection): DOMRect | undefined {
  const [canvas, model] = [shownCanvas(), editedTree()];
  const drawn = canvas && model && (model === canvas.laid.tree ? selection : carried(model, canvas.laid.tree, selection));
  if (canvas === undefined || drawn === undefined) return undefined;
  const path = drawn.kind === "node" ? drawn.path : splitAddress(drawn.address)?.path;
  const node = canvas.laid.drawing.nodes.find((each) => each.path === path);
  const box = drawn.kind === "node" ? node : node?.ports.find(({ address }) => address === drawn.address);
  return box && onScreen(canvas, box);
}

/** The port or innermost node at a point of the screen; nothing: the background. */
export function hitAt(at: ScreenPoint): Selection | undefined {
  const model = editedTree();
  const id = shownCanvas()?.nodeAt(at)?.id;
  return model === undefined || id === undefined ? undefined : selectionsOf(model).get(id);
}

/** What lies over the drawing and has the pointer for itself. */
const kTools = ".breadcrumb, .canvas-tools, .zoom-controls, .react-flow__minimap, .minimap, .layout-progress, .state-toggle, button:not([data-path], [data-address], .state-name)";

/** Whether a point of the screen is on the drawing: not on another part of the page, nor on the tools that lie over it. */
export function isOnDrawing({ x, y }: ScreenPoint): boolean {
  const top = document.elementFromPoint(x, y);
  return top !== null && canvasElement()?.contains(top) === true && top.closest(kTools) === null;
}

/** All nodes that are drawn, by their paths in the model, and where. */
export function drawnNodes(): readonly { readonly path: string; readonly box: DOMRect }[] {
  const [canvas, model] = [shownCanvas(), editedTree()];
  if (canvas === undefined || model === undefined) return [];
  return canvas.laid.drawing.nodes.flatMap((node) => {
    const selection = carried(canvas.laid.tree, model, { kind: "node", path: node.path });
    return selection?.kind === "node" ? [{ path: selection.path, box: onScreen(canvas, node) }] : [];
  });
}

/** Nodes that are drawn wholly inside of a box of the screen, the outermost of them, by their paths. */
export function nodesWithin(box: DOMRect): readonly string[] {
  const inside = (rect: DOMRect) => rect.left >= box.left && rect.right <= box.right && rect.top >= box.top && rect.bottom <= box.bottom;
  const paths = drawnNodes().filter((node) => inside(node.box)).map(({ path }) => path);
  return paths.filter((path) => !paths.some((outer) => path.startsWith(`${outer}/`)));
}

const rowOf = (path: string): Element | null => document.querySelector(`[role="tree"] [data-path="${CSS.escape(path)}"]`);

/** Where to ask about what is selected: at its row of the tree if that has the focus, else at its drawing. */
export function placeOfSelection(): ScreenPoint & { readonly width: number } {
  const { selection } = view.get();
  const [path] = selectedPaths(view.get());
  const row = path !== undefined && document.activeElement?.closest('[role="tree"]') ? rowOf(path)?.getBoundingClientRect() : undefined;
  const box = row ?? (selection && boxOf(selection)) ?? canvasElement()?.getBoundingClientRect();
  return { x: box?.left ?? 0, y: box?.top ?? 0, width: Math.min(260, Math.max(140, box?.width ?? 0)) };
}
