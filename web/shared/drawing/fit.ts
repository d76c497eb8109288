// How a drawing fits its canvas: the first view of it, and how much detail can be read there.
import { kPortsLegible } from "./levels";
import type { Size } from "./measure";

/** Below this zoom the code in a drawing is too small to read. */
const kReadable = 0.68;
const kLargest = 1.25;
/** Kept free for the breadcrumb above, and around [px]. */
export const kTop = 50;
const kAround = 14;

export interface Viewport {
  readonly x: number;
  readonly y: number;
  readonly zoom: number;
}

/** The whole drawing, as large as the canvas allows, in the middle of what the breadcrumb leaves. */
export function fit(drawing: Size, canvas: Size): Viewport {
  const room = { width: canvas.width - 2 * kAround, height: canvas.height - kTop - kAround };
  const zoom = Math.max(0.02, Math.min(kLargest, room.width / drawing.width, room.height / drawing.height));
  return {
    zoom,
    x: kAround + (room.width - drawing.width * zoom) / 2,
    y: kTop + (room.height - drawing.height * zoom) / 2,
  };
}

/** Whether all of a drawing is seen. */
export function shows({ x, y, zoom }: Viewport, drawing: Size, canvas: Size): boolean {
  return x >= 0 && y >= 0 && x + drawing.width * zoom <= canvas.width && y + drawing.height * zoom <= canvas.height;
}

/** The first view when code was asked for: all of the drawing if its ports can be read then, else its beginning, as wide as the canvas. */
export function fitReadable(drawing: Size, canvas: Size): Viewport {
  const whole = fit(drawing, canvas);
  if (whole.zoom >= kPortsLegible) return whole;
  const room = { width: canvas.width - 2 * kAround, height: canvas.height - kTop - kAround };
  const zoom = Math.min(1, Math.max(kPortsLegible, room.width / drawing.width));
  const start = (length: number, space: number, edge: number) => edge + Math.max(0, (space - length * zoom) / 2);
  return { zoom, x: start(drawing.width, room.width, kAround), y: start(drawing.height, room.height, kTop) };
}

export function readable(drawing: Size, canvas: Size): boolean {
  return fit(drawing, canvas).zoom >= kReadable;
}
