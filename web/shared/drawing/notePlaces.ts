// Where notes stand in a drawing: at what they are about, where they cover neither another node nor a line; if there is no such place, as a mark.
import type { Box, DrawnNode, Drawing, Point } from "./drawing";

/** The corner of its element at which a note stands, reaching a little over the border. */
export type NoteCorner = "above" | "above-right" | "below" | "below-right";

const kCorners: readonly NoteCorner[] = ["above", "above-right", "below", "below-right"];

/** As placing.css has it [px]: characters of a line, line, padding, the greatest width, from the corner, and over the border. */
const [kCharacter, kLine, kPadding, kWidest, kInset, kOver] = [6.1, 15, 10, 190, 10, 7];
/** A note shows its first lines. */
const kLines = 2;

function sizeOf(text: string): { readonly width: number; readonly height: number } {
  const widths = text.split("\n").map((line) => line.length * kCharacter);
  const width = Math.min(kWidest, Math.max(...widths) + 2 * kPadding);
  const lines = widths.reduce((sum, each) => sum + Math.max(1, Math.ceil(each / (kWidest - 2 * kPadding))), 0);
  return { width, height: Math.min(kLines, lines) * kLine + kPadding };
}

function boxAt(corner: NoteCorner, of: Box, { width, height }: { readonly width: number; readonly height: number }): Box {
  const x = corner.endsWith("right") ? of.x + of.width - kInset - width : of.x + kInset;
  const y = corner.startsWith("above") ? of.y + kOver - height : of.y + of.height - kOver;
  return { x, y, width, height };
}

const meets = (a: Box, b: Box): boolean => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
const hullOf = (a: Point, b: Point): Box => ({ x: Math.min(a.x, b.x) - 2, y: Math.min(a.y, b.y) - 2, width: Math.abs(a.x - b.x) + 4, height: Math.abs(a.y - b.y) + 4 });

/** What of a node is written on: all of it, or, if what is in it is drawn, the row of its name. */
const kHead = 30;
const writtenOf = (node: DrawnNode): Box => (node.open ? { x: node.x, y: node.y, width: node.width, height: kHead + node.lines.length * 16 } : node);

/** `of`: the node or port that the note is about, of the node at `path`. Nothing: it stands there as a mark. */
export function noteCorner(drawing: Drawing, path: string, of: Box, text: string): NoteCorner | undefined {
  const size = sizeOf(text);
  const isFree = (box: Box): boolean =>
    !drawing.nodes.some((node) => (node.path !== path && meets(box, writtenOf(node))) || node.ports.some((port) => port !== of && meets(box, port))) &&
    !drawing.lines.some(({ points }) => points.some((point, i) => i > 0 && meets(box, hullOf(points[i - 1] ?? point, point))));
  return kCorners.find((corner) => isFree(boxAt(corner, of, size)));
}
