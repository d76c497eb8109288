// A bitmap of a part of the drawing at one zoom, painted tile by tile, so that no frame of the page takes long. What the bitmap before it shows
// already is copied. It is painted aside, and handed to its element when it is whole: without a graphics card the browser copies a canvas that can be
// painted on in each frame in which anything moves.
import type { Viewport } from "../../../shared/drawing/fit";
import type { Box } from "../../../shared/drawing/drawing";
import { showsInside } from "../../../shared/drawing/levels";
import { looksSame } from "../../../shared/drawing/looksSame";
import type { Scene } from "../../../shared/drawing/scene";
import type { Size } from "../../../shared/drawing/measure";
import type { Context } from "./context";
import { paintLine } from "./paintLine";
import { kIdle, paintNode } from "./paintNode";
import { placeAt } from "./placeAt";
import type { Theme } from "./theme";

/** Side of a tile [px]. */
const kTile = 256;
/** Distance of the points behind the drawing; closer on the screen than `least` they are left out [px]. */
const kDots = { gap: 22, least: 9 };

interface Tile {
  readonly left: number;
  readonly top: number;
}

function contextOf(canvas: OffscreenCanvas): Context {
  const context = canvas.getContext("2d", { alpha: false });
  if (context === null) throw new Error("the browser paints no canvas");
  return context;
}

export class Raster {
  private readonly tiles: Tile[];
  /** What is painted, until it is handed over. */
  private aside: OffscreenCanvas | undefined;

  /** `viewport`: of the drawing in the bitmap, whose size is in pixels of the page. `before`: it has some of this already. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly scene: Scene,
    readonly theme: Theme,
    readonly viewport: Viewport,
    readonly size: Size,
    private readonly scale: number,
    before?: Raster,
  ) {
    const known = before?.goesOnIn(this) === true ? before : undefined;
    this.tiles = [];
    for (let top = 0; top < size.height; top += kTile)
      for (let left = 0; left < size.width; left += kTile) if (known?.has({ left, top }, this) !== true) this.tiles.push({ left, top });
    if (known?.canvas === canvas && this.tiles.length === 0) return;
    this.aside = new OffscreenCanvas(Math.max(1, Math.ceil(size.width * scale)), Math.max(1, Math.ceil(size.height * scale)));
    if (known !== undefined) contextOf(this.aside).drawImage(known.canvas, (viewport.x - known.viewport.x) * scale, (viewport.y - known.viewport.y) * scale);
  }

  /** Whether `next` can take pixels of this one as they are. */
  private goesOnIn({ canvas, theme, viewport, size, scale }: Raster): boolean {
    const isWhole = (offset: number) => Number.isInteger(offset * scale);
    const sameGrid = isWhole(viewport.x - this.viewport.x) && isWhole(viewport.y - this.viewport.y);
    const sameCanvas = canvas !== this.canvas || (viewport.x === this.viewport.x && viewport.y === this.viewport.y && size.width === this.size.width && size.height === this.size.height);
    return this.aside === undefined && theme === this.theme && scale === this.scale && viewport.zoom === this.viewport.zoom && sameGrid && sameCanvas;
  }

  /** Whether this one shows a tile of `next` as a whole, and as it is there. */
  private has({ left, top }: Tile, next: Raster): boolean {
    const at = { left: left - next.viewport.x + this.viewport.x, top: top - next.viewport.y + this.viewport.y };
    const [right, bottom] = [Math.min(kTile, next.size.width - left), Math.min(kTile, next.size.height - top)];
    const isIn = at.left >= 0 && at.top >= 0 && at.left + right <= this.size.width && at.top + bottom <= this.size.height;
    return isIn && looksSame(this.scene, next.scene, next.areaOf({ left, top }), next.viewport.zoom);
  }

  private areaOf({ left, top }: Tile): Box {
    const { x, y, zoom } = this.viewport;
    return { x: (left - x) / zoom, y: (top - y) / zoom, width: kTile / zoom, height: kTile / zoom };
  }

  /** Paints further tiles for `budget` [ms]; tells whether all are painted, and then its element shows them. */
  paint(budget: number): boolean {
    if (this.aside === undefined) return true;
    const context = contextOf(this.aside);
    const end = performance.now() + budget;
    while (this.tiles.length > 0 && performance.now() < end) {
      const tile = this.tiles.pop();
      if (tile !== undefined) this.paintTile(context, tile);
    }
    if (this.tiles.length > 0) {
      // The browser only notes what is to be painted; asked for a pixel, it paints, so that not all of it comes in the last frame.
      context.getImageData(0, 0, 1, 1);
      return false;
    }
    this.handOver(this.aside);
    this.aside = undefined;
    return true;
  }

  private handOver(aside: OffscreenCanvas): void {
    const { canvas, scale } = this;
    const { width, height } = aside;
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    canvas.style.width = `${width / scale}px`;
    canvas.style.height = `${height / scale}px`;
    canvas.getContext("bitmaprenderer", { alpha: false })?.transferFromImageBitmap(aside.transferToImageBitmap());
  }

  /** Places the bitmap for this view of the drawing. */
  place(view: Viewport): void {
    placeAt(this.canvas, this.viewport, view, this.scale);
  }

  private paintTile(context: Context, { left, top }: Tile): void {
    const { scale, theme } = this;
    const { x, y, zoom } = this.viewport;
    const area = this.areaOf({ left, top });
    context.save();
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.beginPath();
    context.rect(left, top, kTile, kTile);
    context.clip();
    context.fillStyle = theme.colours.paper;
    context.fillRect(left, top, kTile, kTile);
    context.setTransform(scale * zoom, 0, 0, scale * zoom, scale * x, scale * y);
    this.paintDots(context, area);
    for (const item of this.scene.items.within(area)) {
      if (item.inside !== undefined && !showsInside(item.inside, zoom)) continue;
      if (item.kind === "node") paintNode(context, item.node, zoom, theme, kIdle);
      else paintLine(context, item.line, zoom, theme, "idle");
    }
    context.restore();
  }

  private paintDots(context: Context, { x, y, width, height }: { x: number; y: number; width: number; height: number }): void {
    if (kDots.gap * this.viewport.zoom < kDots.least) return;
    context.fillStyle = this.theme.colours["canvas-dots"];
    const first = (from: number) => Math.floor(from / kDots.gap) * kDots.gap;
    for (let row = first(y); row < y + height; row += kDots.gap) for (let column = first(x); column < x + width; column += kDots.gap) context.fillRect(column, row, 1.2, 1.2);
  }
}
