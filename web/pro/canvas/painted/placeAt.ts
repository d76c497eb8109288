// Moves a bitmap of the drawing, painted for one view, to where another view shows the same.
import type { Viewport } from "../../../shared/drawing/fit";

/** `scale`: pixels of the screen in one of the page; a bitmap that is not scaled keeps to whole ones, so that it stays sharp. */
export function placeAt(canvas: HTMLCanvasElement, painted: Viewport, view: Viewport, scale: number): void {
  const ratio = view.zoom / painted.zoom;
  const whole = (value: number) => (ratio === 1 ? Math.round(value * scale) / scale : value);
  canvas.style.transform = `translate(${whole(view.x - painted.x * ratio)}px, ${whole(view.y - painted.y * ratio)}px) scale(${ratio})`;
}
