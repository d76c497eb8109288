// A bitmap of a part of the drawing at one zoom, painted tile by tile, so that no frame of the page takes long. What the bitmap before it shows
// already is copied.
import type { Viewport } from "../../../shared/drawing/fit";
import type { Box } from "../../../shared/drawing/drawing";
import { showsInside } from "../../../shared/drawing/levels";
import { looksSame } from "../../../shared/drawing/looksSame";
import type { Scene } from "../../../shared/drawing/scene";
import type { Size } from "../../../shared/drawing/measure";
import { paintLine } from "./paintLine";
import { kIdle, paintNode } from "./paintNode";
import type { Theme } from "./theme";

/** Side of a tile [px]. */
const kTile = 256;
/** Distance of the points behind the drawing; closer on the screen than `least` they are left out [px]. */
const kDots = { gap: 22, least: 9 };

interface Tile {
  readonly left: number;
  readonly top: number;
}

export class Raster {
  private readonly context: CanvasRenderingContext2D;
  private readonly tiles: Tile[];

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
    if (known?.canvas !== canvas) {
      canvas.width = Math.ceil(size.width * scale);
      canvas.height = Math.ceil(size.height * scale);
      canvas.style.width = `${canvas.width / scale}px`;
      canvas.style.height = `${canvas.height / scale}px`;
    }
    const context = canvas.getContext("2d", { alpha: false });
    if (context === null) throw new Error("the browser paints no canvas");
    this.context = context;
    if (known !== undefined && known.canvas !== canvas) context.drawImage(known.canvas, (viewport.x - known.viewport.x) * scale, (viewport.y - known.viewport.y) * scale);
    this.tiles = [];
    for (let top = 0; top < size.height; top += kTile)
      for (let left = 0; left < size.width; left += kTile) if (known?.has({ left, top }, this) !== true) this.tiles.push({ left, top });
  }

  /** Whether `next` can take pixels of this one as they are. */
  private goesOnIn({ canvas, theme, viewport, size, scale }: Raster): boolean {
    const isWhole = (offset: number) => Number.isInteger(offset * scale);
    const sameGrid = isWhole(viewport.x - this.viewport.x) && isWhole(viewport.y - this.viewport.y);
    const sameCanvas = canvas !== this.canvas || (viewport.x === this.viewport.x && viewport.y === this.viewport.y && size.width === this.size.width && size.height === this.size.height);
    return this.tiles.length === 0 && theme === this.theme && scale === this.scale && viewport.zoom === this.viewport.zoom && sameGrid && sameCanvas;
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

  /** Paints further tiles for `budget` [ms]; tells whether all are painted. */
  paint(budget: number): boolean {
    const end = performance.now() + budget;
    while (this.tiles.length > 0 && performance.now() < end) {
      const tile = this.tiles.pop();
      if (tile !== undefined) this.paintTile(tile);
    }
    return this.tiles.length === 0;
  }

  /** Places the bitmap for this view of the drawing. */
  place(view: Viewport): void {
    const ratio = view.zoom / this.viewport.zoom;
    const whole = (value: number) => (ratio === 1 ? Math.round(value * this.scale) / this.scale : value);
    this.canvas.style.transform = `translate(${whole(view.x - this.viewport.x * ratio)}px, ${whole(view.y - this.viewport.y * ratio)}px) scale(${ratio})`;
  }

  private paintTile({ left, top }: Tile): void {
    const { context, scale, theme } = this;
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
    this.paintDots(area);
    for (const item of this.scene.items.within(area)) {
      if (item.inside !== undefined && !showsInside(item.inside, zoom)) continue;
      if (item.kind === "node") paintNode(context, item.node, zoom, theme, kIdle);
      else paintLine(context, item.line, zoom, theme, "idle");
    }
    context.restore();
  }

  private paintDots({ x, y, width, height }: { x: number; y: number; width: number; height: number }): void {
    if (kDots.gap * this.viewport.zoom < kDots.least) return;
    this.context.fillStyle = this.theme.colours["canvas-dots"];
    const first = (from: number) => Math.floor(from / kDots.gap) * kDots.gap;
    for (let row = first(y); row < y + height; row += kDots.gap) for (let column = first(x); column < x + width; column += kDots.gap) this.context.fillRect(column, row, 1.2, 1.2);
  }
}
