// Paints the canvas, at most once a frame and only if something has changed: the still drawing as bitmaps that the browser moves
// (Pictures.ts), and over it what a run and the user change (paintLive.ts).
import type { Viewport } from "../../../shared/drawing/fit";
import { isLiveDue, kRest } from "../../../shared/drawing/livePace";
import type { Size } from "../../../shared/drawing/measure";
import { areaOf } from "../../../shared/drawing/movement";
import type { Scene } from "../../../shared/drawing/scene";
import { listenToLive, liveNow } from "../useLive";
import type { Camera } from "./camera";
import { createFlashes } from "./flashes";
import { paintLive, type Marks } from "./paintLive";
import { Pictures } from "./Pictures";
import { placeAt } from "./placeAt";
import { listenToTheme, readTheme, type Theme } from "./theme";

export interface Canvases {
  readonly frame: HTMLElement;
  readonly overview: HTMLCanvasElement;
  readonly pictures: readonly [HTMLCanvasElement, HTMLCanvasElement];
  readonly live: HTMLCanvasElement;
}

export interface Shown {
  readonly scene: Scene;
  readonly size: Size;
  readonly marks: Marks;
}

export class Painter {
  private readonly pictures: Pictures;
  private readonly flashes = createFlashes();
  private readonly ends: readonly (() => void)[];
  private theme: Theme;
  private shown: Shown | undefined;
  private next = 0;
  private resting: ReturnType<typeof setTimeout> | undefined;
  private moved = 0;
  private fireCount = liveNow().fireCount;
  /** Of what lies on the canvas for what is live: for which view and when it was painted; nothing: it is empty. */
  private painted: { readonly view: Viewport; readonly at: number } | undefined;
  /** What is shown has changed since. */
  private changed = false;

  constructor(
    private readonly canvases: Canvases,
    private readonly camera: Camera,
  ) {
    this.pictures = new Pictures(canvases.overview, canvases.pictures);
    this.theme = readTheme();
    const themed = () => {
      this.theme = readTheme();
      this.changed = true;
      this.schedule();
    };
    this.ends = [listenToTheme(themed), camera.listen(() => this.onMove()), listenToLive(() => this.onLive())];
  }

  show(shown: Shown): void {
    this.shown = shown;
    this.changed = true;
    this.schedule();
  }

  close(): void {
    cancelAnimationFrame(this.next);
    clearTimeout(this.resting);
    this.ends.forEach((end) => end());
  }

  private schedule(): void {
    if (this.next === 0) this.next = requestAnimationFrame(() => this.frame());
  }

  /** In a frame of the page. */
  private onMove(): void {
    this.moved = performance.now();
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.schedule(), kRest);
    cancelAnimationFrame(this.next);
    this.frame();
  }

  private onLive(): void {
    const { fired, fireCount } = liveNow();
    if (fireCount !== this.fireCount) this.flashes.add([...fired], performance.now());
    this.fireCount = fireCount;
    this.schedule();
  }

  private frame(): void {
    this.next = 0;
    if (this.shown === undefined) return;
    const now = performance.now();
    const { scene, size } = this.shown;
    const more = this.pictures.frame({ scene, theme: this.theme }, this.camera.viewport(), size, now - this.moved);
    const live = this.frameLive(this.shown, now);
    if (more || live) this.schedule();
  }

  /** Tells whether the next frame may have to differ from this one. */
  private frameLive(shown: Shown, now: number): boolean {
    const { size, marks } = shown;
    const view = this.camera.viewport();
    const { run } = liveNow();
    const empty = run === undefined && marks.nodes.length === 0 && marks.port === undefined && marks.hovered === undefined && marks.errors.size === 0;
    if (empty && this.painted === undefined) return false;
    if (!this.changed && this.painted !== undefined && !isLiveDue(now, this.painted.at, this.moved)) {
      placeAt(this.canvases.live, this.painted.view, view, devicePixelRatio);
      return true;
    }
    this.changed = false;
    this.painted = empty ? undefined : { view, at: now };
    const context = this.clearedLive(size);
    placeAt(this.canvases.live, view, view, devicePixelRatio);
    if (context === undefined || empty) return false;
    const flashes = run === undefined ? new Map<string, number>() : this.flashes.at(now);
    const scale = devicePixelRatio;
    context.setTransform(scale * view.zoom, 0, 0, scale * view.zoom, scale * view.x, scale * view.y);
    paintLive({ context, scene: shown.scene, theme: this.theme, view, area: areaOf(view, size), live: liveNow(), flashes }, marks);
    return flashes.size > 0;
  }

  /** The canvas for what is live, with nothing on it. */
  private clearedLive(size: Size): CanvasRenderingContext2D | undefined {
    const { live: canvas } = this.canvases;
    const scale = devicePixelRatio;
    const [width, height] = [Math.round(size.width * scale), Math.round(size.height * scale)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext("2d") ?? undefined;
    context?.setTransform(1, 0, 0, 1, 0, 0);
    context?.clearRect(0, 0, width, height);
    return context;
  }
}
