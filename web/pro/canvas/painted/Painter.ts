// Paints the canvas, at most once a frame and only if something has changed: the still drawing as bitmaps that the browser moves
// (Pictures.ts), and over it what a run and the user change (paintLive.ts).
import type { Size } from "../../../shared/drawing/measure";
import { areaOf } from "../../../shared/drawing/movement";
import type { Scene } from "../../../shared/drawing/scene";
import { listenToLive, liveNow } from "../useLive";
import type { Camera } from "./camera";
import { createFlashes } from "./flashes";
import { paintLive, type Marks } from "./paintLive";
import { kRest, Pictures } from "./Pictures";
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
  /** Something lies on the canvas for what is live. */
  private painted = false;

  constructor(
    private readonly canvases: Canvases,
    private readonly camera: Camera,
  ) {
    this.pictures = new Pictures(canvases.overview, canvases.pictures);
    this.theme = readTheme();
    const themed = () => {
      this.theme = readTheme();
      this.schedule();
    };
    this.ends = [listenToTheme(themed), camera.listen(() => this.onMove()), listenToLive(() => this.onLive())];
  }

  show(shown: Shown): void {
    this.shown = shown;
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

  private onMove(): void {
    this.moved = performance.now();
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.schedule(), kRest);
    this.schedule();
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
    const flashing = this.frameLive(this.shown, now);
    if (more || flashing) this.schedule();
  }

  /** Tells whether something flashes, so that the next frame differs from this one. */
  private frameLive({ scene, size, marks }: Shown, now: number): boolean {
    const { live: canvas } = this.canvases;
    const live = liveNow();
    const flashes = live.run === undefined ? new Map<string, number>() : this.flashes.at(now);
    const empty = live.run === undefined && marks.nodes.length === 0 && marks.port === undefined && marks.hovered === undefined && marks.errors.size === 0;
    if (empty && !this.painted) return false;
    const scale = devicePixelRatio;
    const [width, height] = [Math.round(size.width * scale), Math.round(size.height * scale)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext("2d");
    if (context === null) return false;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    this.painted = !empty;
    const view = this.camera.viewport();
    context.setTransform(scale * view.zoom, 0, 0, scale * view.zoom, scale * view.x, scale * view.y);
    if (!empty) paintLive({ context, scene, theme: this.theme, view, area: areaOf(view, size), live, flashes }, marks);
    return flashes.size > 0;
  }
}
