// A line of the drawing on a canvas, as ModelLine draws it.
import type { DrawnLine, Point } from "../../../shared/drawing/drawing";
import type { Context } from "./context";
import type { Theme } from "./theme";

export type LineLook = "idle" | "active" | "fired" | "touched";

/** Below this zoom corners are sharp and lines have no heads. */
const kFine = 0.25;
const kRadius = 7;
const kHead = 9;

function head(context: Context, from: Point, tip: Point, open: boolean): void {
  const along = Math.atan2(tip.y - from.y, tip.x - from.x);
  const at = (back: number, aside: number): [number, number] => [tip.x - back * Math.cos(along) - aside * Math.sin(along), tip.y - back * Math.sin(along) + aside * Math.cos(along)];
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(...at(open ? kHead * 0.8 : kHead, kHead * 0.45));
  context.lineTo(tip.x, tip.y);
  context.lineTo(...at(open ? kHead * 0.8 : kHead, -kHead * 0.45));
  if (open) {
    context.stroke();
    return;
  }
  context.closePath();
  context.fillStyle = context.strokeStyle;
  context.fill();
}

function colourOf({ kind }: DrawnLine, look: LineLook, { colours }: Theme): string {
  if (look === "fired") return colours["fired-line"];
  if (look === "active") return colours.active;
  if (look === "touched") return colours.accent;
  return kind === "exit" || kind === "nowhere" ? colours["line-quiet"] : colours.line;
}

/** `flash`: how strongly it flashes, 1 to 0. */
export function paintLine(context: Context, line: DrawnLine, zoom: number, theme: Theme, look: LineLook, flash = 0): void {
  const [start, ...rest] = line.points;
  const tip = rest.at(-1);
  if (start === undefined || tip === undefined) return;
  const open = line.kind === "exit" || line.kind === "nowhere";
  const fine = zoom >= kFine;
  context.strokeStyle = flash > 0.5 ? theme.colours["fired-flash"] : colourOf(line, look, theme);
  // Thin lines stay visible from afar.
  context.lineWidth = Math.max((open ? 1.3 : look === "touched" ? 2 : 1.5) + 3.5 * flash, (look === "idle" ? 0.6 : 1.2) / zoom);
  context.setLineDash(open && fine ? [5, 4] : []);
  context.beginPath();
  context.moveTo(start.x, start.y);
  rest.forEach((point, i) => {
    const next = rest[i + 1];
    if (next === undefined || !fine) context.lineTo(point.x, point.y);
    else context.arcTo(point.x, point.y, next.x, next.y, Math.min(kRadius, Math.hypot(next.x - point.x, next.y - point.y) / 2));
  });
  context.stroke();
  if (!fine) return;
  head(context, line.points[line.points.length - 2] ?? start, tip, open);
  if (line.kind !== "first") return;
  context.beginPath();
  context.arc(start.x, start.y, 4, 0, 2 * Math.PI);
  context.fillStyle = theme.colours.solid;
  context.fill();
}
