// The still part of the painted canvas: an overview of the whole drawing beneath, and a sharp bitmap of what is seen and some more
// around. While the view moves, the browser's compositor moves and scales them; a new bitmap is painted aside and shown when it is whole.
import type { Box } from "../../../shared/drawing/drawing";
import type { Viewport } from "../../../shared/drawing/fit";
import { kRest } from "../../../shared/drawing/livePace";
import type { Size } from "../../../shared/drawing/measure";
import { areaOf } from "../../../shared/drawing/movement";
import type { Scene } from "../../../shared/drawing/scene";
import { Raster } from "./Raster";
import type { Theme } from "./theme";

/** How much is painted around what is seen, as a share of its size; less than `reserve` left: a new bitmap is painted. */
const kAround = 0.3;
const kReserve = 0.08;
/** A bitmap is not shown larger or smaller than by this factor while zooming. */
const kStretch = 1.9;
/** Time for painting in a frame while the view moves, and after the drawing has changed [ms]. */
const kBudget = { moving: 4, changed: 30 };
const kOverview = 1100;

interface Subject {
  readonly scene: Scene;
  readonly theme: Theme;
}

const contains = (outer: Box, inner: Box): boolean =>
  outer.x <= inner.x && outer.y <= inner.y && inner.x + inner.width <= outer.x + outer.width && inner.y + inner.height <= outer.y + outer.height;

export class Pictures {
  private overview: Raster | undefined;
  private front: Raster | undefined;
  private back: Raster | undefined;
  private free: HTMLCanvasElement[];

  constructor(
    private readonly overviewCanvas: HTMLCanvasElement,
    [one, other]: readonly [HTMLCanvasElement, HTMLCanvasElement],
  ) {
    this.free = [one, other];
  }

  /** Paints what has to be painted for this view and places all; tells whether there is more to paint. `rested`: for how long the view has not moved [ms]. */
  frame(subject: Subject, view: Viewport, size: Size, rested: number): boolean {
    const changed = this.front === undefined || !this.shows(this.front, subject);
    if (this.back !== undefined && !this.shows(this.back, subject)) this.dropBack();
    if (this.back === undefined && (changed || this.isWorn(this.front, view, size, rested))) this.back = this.begin(subject, view, size);
    if (this.back?.paint(changed ? kBudget.changed : kBudget.moving) === true) this.take(this.back);
    const overview = this.frameOverview(subject, view);
    this.front?.place(view);
    return this.back !== undefined || overview || (this.front !== undefined && this.front.viewport.zoom !== view.zoom);
  }

  private shows(raster: Raster, { scene, theme }: Subject): boolean {
    return raster.scene === scene && raster.theme === theme;
  }

  private isWorn(front: Raster | undefined, view: Viewport, size: Size, rested: number): boolean {
    if (front === undefined) return true;
    const ratio = view.zoom / front.viewport.zoom;
    if (ratio !== 1) return rested >= kRest || ratio > kStretch || ratio < 1 / kStretch;
    const seen = areaOf(view, size);
    const reserve = { x: seen.x - seen.width * kReserve, y: seen.y - seen.height * kReserve, width: seen.width * (1 + 2 * kReserve), height: seen.height * (1 + 2 * kReserve) };
    return !contains(areaOf(front.viewport, front.size), reserve);
  }

  private begin({ scene, theme }: Subject, view: Viewport, { width, height }: Size): Raster | undefined {
    const canvas = this.free.pop();
    if (canvas === undefined) return undefined;
    const around = { x: Math.round(width * kAround), y: Math.round(height * kAround) };
    const size = { width: width + 2 * around.x, height: height + 2 * around.y };
    const before = this.front?.viewport.zoom === view.zoom ? this.front : undefined;
    // In whole pixels from the bitmap before, so that what that shows can be copied.
    const along = (at: number, from: number | undefined) => (from === undefined ? at : from + Math.round((at - from) * devicePixelRatio) / devicePixelRatio);
    const viewport = { x: along(view.x + around.x, before?.viewport.x), y: along(view.y + around.y, before?.viewport.y), zoom: view.zoom };
    return new Raster(canvas, scene, theme, viewport, size, devicePixelRatio, before);
  }

  private dropBack(): void {
    if (this.back !== undefined) this.free.push(this.back.canvas);
    this.back = undefined;
  }

  private take(raster: Raster): void {
    if (this.front !== undefined) {
      this.front.canvas.style.visibility = "hidden";
      this.free.push(this.front.canvas);
    }
    this.front = raster;
    this.back = undefined;
    raster.canvas.style.visibility = "visible";
  }

  /** The overview is painted after the sharp bitmap; until then the old one is not shown. */
  private frameOverview(subject: Subject, view: Viewport): boolean {
    if (this.overview === undefined || !this.shows(this.overview, subject)) {
      this.overviewCanvas.style.visibility = "hidden";
      if (this.back !== undefined) return true;
      const { width, height } = subject.scene.drawing;
      const zoom = Math.min(1, kOverview / Math.max(width, height));
      this.overview = new Raster(this.overviewCanvas, subject.scene, subject.theme, { x: 0, y: 0, zoom }, { width: width * zoom, height: height * zoom }, 1, this.overview);
    }
    if (!this.overview.paint(kBudget.moving)) return true;
    this.overviewCanvas.style.visibility = "visible";
    this.overview.place(view);
    return false;
  }
}
