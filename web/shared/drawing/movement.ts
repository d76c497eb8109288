// Moving and zooming the view of a drawing, as values.
import type { Box, Point } from "./drawing";
import type { Viewport } from "./fit";
import type { Size } from "./measure";

/** The smallest is that of `fit`: a drawing of some thousand states. */
export const kZoomLimits = { least: 0.02, most: 2.5 };

const clampZoom = (zoom: number): number => Math.min(kZoomLimits.most, Math.max(kZoomLimits.least, zoom));

/** What lies at `point` (of the canvas) stays there. */
export function zoomedAt({ x, y, zoom }: Viewport, point: Point, factor: number): Viewport {
  const next = clampZoom(zoom * factor);
  const ratio = next / zoom;
  return { x: point.x - (point.x - x) * ratio, y: point.y - (point.y - y) * ratio, zoom: next };
}

export const movedBy = ({ x, y, zoom }: Viewport, by: Point): Viewport => ({ x: x + by.x, y: y + by.y, zoom });

/** Zooms with `point` of the drawing in the middle of the canvas. */
export const centredOn = (point: Point, zoom: number, canvas: Size): Viewport => ({ x: canvas.width / 2 - point.x * zoom, y: canvas.height / 2 - point.y * zoom, zoom });

/** A box of the drawing in the middle of the canvas, with as much room around as it needs itself. */
export function fitBox({ x, y, width, height }: Box, canvas: Size): Viewport {
  const kRoom = 2.2;
  const zoom = Math.max(kZoomLimits.least, Math.min(1.1, canvas.width / (width * kRoom), canvas.height / (height * kRoom)));
  return centredOn({ x: x + width / 2, y: y + height / 2 }, zoom, canvas);
}

/** The factor of a turn of the wheel; a pinch on a touchpad comes as a wheel with Ctrl. */
export function wheelFactor({ deltaY, deltaMode, ctrlKey }: { readonly deltaY: number; readonly deltaMode: number; readonly ctrlKey: boolean }): number {
  const unit = deltaMode === 1 ? 0.05 : deltaMode === 0 ? 0.002 : 1;
  return 2 ** (-deltaY * unit * (ctrlKey ? 10 : 1));
}

/** The part of the drawing that is seen. */
export const areaOf = ({ x, y, zoom }: Viewport, { width, height }: Size): Box => ({ x: -x / zoom, y: -y / zoom, width: width / zoom, height: height / zoom });

/** The view between two others, `share` of the way (0 to 1). */
export function between(from: Viewport, to: Viewport, share: number): Viewport {
  const mix = (a: number, b: number) => a + (b - a) * share;
  return { x: mix(from.x, to.x), y: mix(from.y, to.y), zoom: mix(from.zoom, to.zoom) };
}
