// Following a run in its drawing: what became active, which level shows it, and where the view has to go.
import type { Box } from "./drawing";
import { fit, kTop, type Viewport } from "./fit";
import { kPortsLegible } from "./levels";
import type { Size } from "./measure";
import { centredOn } from "./movement";

/** The innermost of the nodes that are active now and were not before. */
export function becameActive(before: ReadonlySet<string>, now: ReadonlySet<string>): readonly string[] {
  const outer = new Set([...now].map((path) => path.slice(0, Math.max(0, path.lastIndexOf("/")))));
  return [...now].filter((path) => !before.has(path) && !outer.has(path));
}

/** The state that all these are in: the parent of one alone. */
export function commonLevel(paths: readonly string[]): string {
  const [first = [], ...others] = paths.map((path) => path.split("/").slice(0, -1));
  const end = first.findIndex((name, i) => others.some((other) => other[i] !== name));
  return (end < 0 ? first : first.slice(0, end)).join("/");
}

function around(boxes: readonly Box[]): Box | undefined {
  if (boxes.length === 0) return undefined;
  const [x, y] = [Math.min(...boxes.map((box) => box.x)), Math.min(...boxes.map((box) => box.y))];
  return { x, y, width: Math.max(...boxes.map((box) => box.x + box.width)) - x, height: Math.max(...boxes.map((box) => box.y + box.height)) - y };
}

/** Kept free around what is followed [px]. */
const kAround = 24;

const isSame = (one: Viewport, other: Viewport): boolean => Math.abs(one.x - other.x) < 1 && Math.abs(one.y - other.y) < 1 && Math.abs(one.zoom / other.zoom - 1) < 0.01;

/**
 * The view that shows these boxes so that their ports can be read: the whole drawing if it can be read as a whole or there are no boxes, else a
 * part of it; larger boxes as a whole, smaller. Nothing: they are seen like that.
 */
export function followView(boxes: readonly Box[], now: Viewport, drawing: Size, canvas: Size): Viewport | undefined {
  const whole = fit(drawing, canvas);
  if (whole.zoom >= kPortsLegible) return isSame(now, whole) ? undefined : whole;
  const box = around(boxes);
  if (box === undefined) return isSame(now, whole) ? undefined : whole;
  const room = { width: canvas.width - 2 * kAround, height: canvas.height - kTop - kAround };
  const zoom = Math.max(whole.zoom, Math.min(kPortsLegible, room.width / box.width, room.height / box.height));
  const [left, top] = [now.x + box.x * now.zoom, now.y + box.y * now.zoom];
  const isSeen = left >= 0 && top >= kTop && left + box.width * now.zoom <= canvas.width && top + box.height * now.zoom <= canvas.height;
  if (isSeen && now.zoom >= zoom * 0.99) return undefined;
  const view = centredOn({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, zoom, canvas);
  return { ...view, y: view.y + (kTop - kAround) / 2 };
}
