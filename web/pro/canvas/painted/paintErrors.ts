// The errors of a document that is edited, over the still drawing: at the nodes and ports that are painted, with their numbers.
import { showsInside, showsPorts } from "../../../shared/drawing/levels";
import type { Box } from "../../../shared/drawing/drawing";
import type { Scene, SceneNode } from "../../../shared/drawing/scene";
import { ancestry } from "../../../shared/model/modelTree";
import type { Context } from "./context";
import type { Theme } from "./theme";

/** Numbers of errors by path of a node, with its ports, and by address of a port. */
export type ErrorCounts = ReadonlyMap<string, number>;

/** The innermost node that is painted for the one at `path`. */
function paintedFor(scene: Scene, path: string, zoom: number): SceneNode | undefined {
  const drawn = [...ancestry(path)].reverse().map((part) => scene.node(part)).find((item) => item !== undefined);
  let found = drawn;
  while (found?.inside !== undefined && !showsInside(found.inside, zoom)) found = scene.node(found.inside.path);
  return found;
}

/** For each node that is painted: the errors of it and of what is in it and not painted. */
export function errorsShown(scene: Scene, errors: ErrorCounts, zoom: number): ReadonlyMap<SceneNode, number> {
  const shown = new Map<SceneNode, number>();
  for (const [key, count] of errors) {
    const node = scene.port(key) === undefined ? paintedFor(scene, key, zoom) : undefined;
    if (node !== undefined) shown.set(node, (shown.get(node) ?? 0) + count);
  }
  return shown;
}

function outline(context: Context, { x, y, width, height }: Box, radius: number, pixel: number): void {
  context.beginPath();
  context.roundRect(x - pixel, y - pixel, width + 2 * pixel, height + 2 * pixel, radius);
  context.stroke();
}

export function paintErrors(context: Context, scene: Scene, errors: ErrorCounts, zoom: number, { colours, sans }: Theme): void {
  // Also a font that is set and not used costs time, in each frame.
  if (errors.size === 0) return;
  const pixel = 1 / Math.min(1, zoom);
  context.setLineDash([]);
  context.strokeStyle = colours.bad;
  context.lineWidth = 2 * pixel;
  for (const address of errors.keys()) {
    const found = scene.port(address);
    if (found !== undefined && showsPorts(found.of.node, zoom) && (found.of.inside === undefined || showsInside(found.of.inside, zoom))) outline(context, found.port, pixel, pixel);
  }
  context.font = `600 ${10.5 * pixel}px ${sans}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const [{ node }, count] of errorsShown(scene, errors, zoom)) {
    outline(context, node, 13, pixel);
    const wide = Math.max(18 * pixel, context.measureText(String(count)).width + 10 * pixel);
    context.beginPath();
    context.roundRect(node.x - 9 * pixel, node.y - 9 * pixel, wide, 18 * pixel, 9 * pixel);
    context.fillStyle = colours.bad;
    context.fill();
    context.fillStyle = colours["on-fill"];
    context.fillText(String(count), node.x - 9 * pixel + wide / 2, node.y + pixel / 2);
  }
  context.textAlign = "left";
}
