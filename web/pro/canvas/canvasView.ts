// The canvas that is shown, as gestures see it: what lies where, and the way between points of the page and of the drawing.
// There is one at a time, whichever way it is painted.
import type { Point } from "../../shared/drawing/drawing";
import type { Viewport } from "../../shared/drawing/fit";
import { hitIndex, type Hit } from "../../shared/drawing/hit";
import { idAt } from "../../shared/model/identity";
import { createStore, useSelected } from "../../page/store";
import type { Laid } from "./useDrawing";

/** What lies at a point of the page: a node, or a port of it. */
export interface CanvasHit {
  readonly path: string;
  /** Of the port, if there is one at the point, else of the node. */
  readonly id: string | undefined;
  /** The address of the port. */
  readonly port?: string;
}

/** Points of the page are as in pointer events (clientX, clientY). */
export interface CanvasView {
  /** What is drawn; paths are those of `laid.tree`. */
  readonly laid: Laid;
  /** The element that the drawing is seen through. Its events are those of the canvas; a press whose `pointerdown` is default-prevented
   *  (in the capture phase) does not move the drawing. */
  readonly element: HTMLElement;
  readonly viewport: () => Viewport;
  /** Where a movement that is under way leads to, else the viewport: what is decided while the drawing moves is decided for where it will rest. */
  readonly target: () => Viewport;
  /** Shows another part of the drawing, gradually over `duration` [ms]. */
  readonly show: (viewport: Viewport, duration?: number) => void;
  /** The port or innermost node at a point of the page; none beside the drawing. */
  readonly nodeAt: (point: Point) => CanvasHit | undefined;
  readonly toModel: (point: Point) => Point;
  readonly toScreen: (point: Point) => Point;
  /** Calls `listener` whenever the viewport changes; the result ends that. */
  readonly listen: (listener: () => void) => () => void;
}

/** How a canvas is moved: what its two ways of painting do each in their way. */
export type Movable = Pick<CanvasView, "laid" | "element" | "viewport" | "show" | "listen">;

interface Movement {
  readonly to: Viewport;
  /** By `performance.now()` [ms]. */
  readonly end: number;
}

/** The latest movement of each element's drawing; it outlives the views, of which each drawing makes one. */
const movements = new WeakMap<HTMLElement, Movement>();

/** `seen`: what is painted for what lies at a point; a painted canvas leaves out what would be too small. */
export function canvasView(canvas: Movable, seen: (hit: Hit) => Hit = (hit) => hit): CanvasView {
  const { laid, element, viewport } = canvas;
  const toModel = (point: Point): Point => {
    const { x, y, zoom } = viewport();
    const { left, top } = element.getBoundingClientRect();
    return { x: (point.x - left - x) / zoom, y: (point.y - top - y) / zoom };
  };
  const toScreen = (point: Point): Point => {
    const { x, y, zoom } = viewport();
    const { left, top } = element.getBoundingClientRect();
    return { x: left + x + point.x * zoom, y: top + y + point.y * zoom };
  };
  const nodeAt = (point: Point): CanvasHit | undefined => {
    const found = hitIndex(laid.drawing).at(toModel(point));
    if (found === undefined) return undefined;
    const hit = seen(found);
    const { path, port } = hit;
    return { ...hit, id: idAt(laid.tree, port === undefined ? { kind: "node", path } : { kind: "port", address: port }) };
  };
  const target = (): Viewport => {
    const movement = movements.get(element);
    return movement !== undefined && performance.now() < movement.end ? movement.to : viewport();
  };
  const show = (to: Viewport, duration = 0) => {
    movements.set(element, { to, end: performance.now() + duration });
    canvas.show(to, duration);
  };
  return { ...canvas, show, target, toModel, toScreen, nodeAt };
}

const shown = createStore<CanvasView | undefined, CanvasView | undefined>(undefined, (_, next) => next);

/** The canvas that is shown; none while nothing is drawn. */
export const shownCanvas = (): CanvasView | undefined => shown.get();

export const useShownCanvas = (): CanvasView | undefined => useSelected(shown, (canvas) => canvas);

/** Makes a canvas the one that is shown; the result ends that. */
export function showCanvas(canvas: CanvasView): () => void {
  shown.dispatch(canvas);
  return () => {
    if (shown.get() === canvas) shown.dispatch(undefined);
  };
}
