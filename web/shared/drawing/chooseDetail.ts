// How much detail can be read at first fit.
import type { Drawing } from "./drawing";

/** Below this zoom the conditions of ports are too small to read. */
const kReadable = 0.72;

/** The zoom at which a drawing fills a canvas, at most 1.25. */
export function fitZoom(drawing: Drawing, canvas: { readonly width: number; readonly height: number }): number {
  return Math.min(1.25, canvas.width / drawing.width, canvas.height / drawing.height);
}

/** Whether the full drawing may be shown at first, or the slim one serves better. */
export function readable(drawing: Drawing, canvas: { readonly width: number; readonly height: number }): boolean {
  return fitZoom(drawing, canvas) >= kReadable;
}
