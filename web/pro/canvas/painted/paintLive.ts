// What changes over the still drawing: the state of the run, what is selected and what the pointer is over.
import type { Viewport } from "../../../shared/drawing/fit";
import { showsCode, showsInside, showsPorts } from "../../../shared/drawing/levels";
import { liveValue, type Live } from "../../../shared/drawing/live";
import type { Box } from "../../../shared/drawing/drawing";
import type { Scene, SceneItem, SceneLine, SceneNode } from "../../../shared/drawing/scene";
import { waitingState } from "../../../shared/model/afters";
import { clip, valueText } from "../../../shared/model/describe";
import type { Context } from "./context";
import { paintErrors, type ErrorCounts } from "./paintErrors";
import { paintLine, type LineLook } from "./paintLine";
import { paintNode, type NodeLook } from "./paintNode";
import { paintPort } from "./paintPort";
import type { Theme } from "./theme";

/** What is marked besides the run. */
export interface Marks {
  readonly nodes: readonly string[];
  readonly port: string | undefined;
  /** Address of the port under the pointer. */
  readonly hovered: string | undefined;
  readonly errors: ErrorCounts;
}

export interface LivePicture {
  readonly context: Context;
  readonly scene: Scene;
  readonly theme: Theme;
  readonly view: Viewport;
  readonly area: Box;
  readonly live: Live;
  readonly flashes: ReadonlyMap<string, number>;
}

const meets = (a: Box, b: Box): boolean => a.x <= b.x + b.width && b.x <= a.x + a.width && a.y <= b.y + b.height && b.y <= a.y + a.height;

const isSeen = ({ area, view }: LivePicture, item: SceneItem): boolean => meets(item, area) && (item.inside === undefined || showsInside(item.inside, view.zoom));

function lookOf({ scene, live }: LivePicture, { node }: SceneNode): NodeLook {
  const { path } = node;
  const arrived = live.activated[path]?.length ?? 0;
  const inbound = node.kind === "barrier" && arrived > 0 ? scene.inbound(path).length : 0;
  return {
    active: live.active.has(path),
    faulted: live.faultAt === path,
    waiting: arrived > 0 && arrived < inbound ? `${arrived}/${inbound}` : undefined,
    value: (line) => {
      const value = line.label === "params" ? undefined : liveValue(live, path, line);
      return value === undefined ? undefined : clip(valueText(value), 18);
    },
    port: (address) => ({
      active: live.ports.has(address),
      endsBadly: live.badEnd === address,
      waits: live.active.has(waitingState(address)),
      faulted: live.faultAt !== undefined && live.faultAt === waitingState(address),
    }),
  };
}

/** The nodes that do not look as in the still drawing: near, what is seen is looked at; from afar, what the run says. */
function changedNodes(picture: LivePicture): readonly SceneNode[] {
  const { scene, live, area, view } = picture;
  if (live.run === undefined) return [];
  if (showsCode(view.zoom))
    return scene.items.within(area).filter((item): item is SceneNode => {
      if (item.kind === "line") return false;
      const look = lookOf(picture, item);
      return look.active || look.faulted || look.waiting !== undefined || item.node.ports.some(({ address }) => look.port(address).active) || item.node.lines.some((line) => look.value(line) !== undefined);
    });
  const paths = new Set([...live.active, ...Object.keys(live.activated), ...(live.faultAt === undefined ? [] : [live.faultAt])]);
  return [...paths].flatMap((path) => scene.node(path) ?? []).filter((item) => isSeen(picture, item));
}

function lineLook({ live, flashes }: LivePicture, { line }: SceneLine): LineLook {
  if (flashes.has(line.from)) return "fired";
  return live.ports.has(line.from) ? "active" : "idle";
}

const firedLines = ({ scene, live, flashes }: LivePicture): readonly SceneLine[] => [...new Set([...live.ports, ...flashes.keys()])].flatMap((address) => scene.linesFrom(address));

function paintPorts(picture: LivePicture): void {
  const { context, scene, theme, view, live, flashes } = picture;
  for (const address of new Set([...live.ports, ...flashes.keys()])) {
    const found = scene.port(address);
    if (found === undefined || !isSeen(picture, found.of) || !showsPorts(found.of.node, view.zoom)) continue;
    const flash = flashes.get(address) ?? 0;
    const { port, of } = found;
    if (flash > 0) {
      const reach = 10 * flash;
      context.fillStyle = theme.colours["active-glow"];
      context.fillRect(port.x - reach, port.y - reach, port.width + 2 * reach, port.height + 2 * reach);
    }
    if (flash > 0 || live.ports.has(address)) paintPort(context, port, of.node, view.zoom, theme, lookOf(picture, of).port(address));
  }
}

function outline({ context, theme, view }: LivePicture, { x, y, width, height }: Box, around: number, radius: number): void {
  const reach = around / Math.min(1, view.zoom);
  context.setLineDash([]);
  context.strokeStyle = theme.colours.accent;
  context.lineWidth = 2 / Math.min(1, view.zoom);
  context.beginPath();
  context.roundRect(x - reach, y - reach, width + 2 * reach, height + 2 * reach, radius);
  context.stroke();
}

function paintMarks(picture: LivePicture, { nodes, port, hovered, errors }: Marks): void {
  const { context, scene, theme, view } = picture;
  paintErrors(context, scene, errors, view.zoom, theme);
  const first = port ?? nodes[0];
  for (const item of first === undefined ? [] : scene.linesAt(first)) if (isSeen(picture, item)) paintLine(context, item.line, view.zoom, theme, "touched");
  for (const path of nodes) {
    const item = scene.node(path);
    if (item !== undefined && meets(item, picture.area)) outline(picture, item.node, 3, 13);
  }
  for (const [address, around] of [[port, 2], [hovered, 0]] as const) {
    const found = address === undefined ? undefined : scene.port(address);
    if (found !== undefined && showsPorts(found.of.node, view.zoom)) outline(picture, found.port, around, 1);
  }
}

/** Paints over a transparent canvas. */
export function paintLive(picture: LivePicture, marks: Marks): void {
  const { context, theme, view } = picture;
  const lines = firedLines(picture).filter((line) => isSeen(picture, line));
  const items: readonly SceneItem[] = [...changedNodes(picture), ...lines].sort((a, b) => a.order - b.order);
  for (const item of items) {
    if (item.kind === "node") paintNode(context, item.node, view.zoom, theme, lookOf(picture, item), true);
    else paintLine(context, item.line, view.zoom, theme, lineLook(picture, item), picture.flashes.get(item.line.from) ?? 0);
  }
  paintPorts(picture);
  paintMarks(picture, marks);
}
