// A state or barrier on a canvas, in the notation and with the measures of StateNode, BarrierNode and canvas.css.
import type { Box, DrawnNode } from "../../../shared/drawing/drawing";
import { fittingName, headHeight, nameSize, showsCode, showsInside, showsPorts } from "../../../shared/drawing/levels";
import type { Line } from "../../../shared/model/describe";
import type { Dispatcher } from "../../../shared/model/model";
import type { Context } from "./context";
import { paintPort, type PortLook } from "./paintPort";
import type { Theme } from "./theme";

/** How a node looks now. */
export interface NodeLook {
  readonly active: boolean;
  readonly faulted: boolean;
  /** What a barrier waits for, as `1/2`; none: it does not wait. */
  readonly waiting?: string | undefined;
  /** The live value of a line of the text section. */
  readonly value: (line: Line) => string | undefined;
  readonly port: (address: string) => PortLook;
}

export const kIdle: NodeLook = { active: false, faulted: false, value: () => undefined, port: () => ({ active: false, endsBadly: false, waits: false, faulted: false }) };

/** The signs of dispatchers: those of UML for histories. */
export const kSigns: Readonly<Record<Dispatcher, string>> = { history: "H", "deep history": "H*", choice: "?" };

/** The button that opens and closes a composite, in the coordinates of the drawing; it lies in the row of the name. */
export function toggleBox({ x, y, width, side, open, ports }: DrawnNode, zoom: number): Box {
  const covered = side === "EAST" && !open && ports.length > 0 ? 14 : 0;
  return { x: x + width - covered - 8 - 17, y: y + (headHeight(zoom) - 17) / 2, width: 17, height: 17 };
}

function frame(context: Context, { x, y, width, height, dispatcher }: DrawnNode, zoom: number): void {
  context.beginPath();
  const radius = dispatcher === undefined ? 12 : Math.min(width, height) / 2;
  if (radius * zoom < 1.5) context.rect(x, y, width, height);
  else context.roundRect(x, y, width, height, radius);
}

function surface({ dispatcher, open }: DrawnNode, { active, faulted }: NodeLook, theme: Theme): { readonly fill: string; readonly border: string } {
  const { colours } = theme;
  if (faulted) return { fill: colours["bad-soft"], border: colours.bad };
  if (active) return { fill: colours["active-soft"], border: colours.active };
  if (dispatcher !== undefined) return { fill: colours["oracle-soft"], border: colours.oracle };
  return open ? { fill: colours.inset, border: colours["edge-strong"] } : { fill: colours.panel, border: colours.outline };
}

function paintHead(context: Context, node: DrawnNode, zoom: number, theme: Theme, look: NodeLook): void {
  const size = nameSize(node, zoom);
  if (size === 0) return;
  const { colours, sans } = theme;
  const { x, y, width, height, side, composite, badge, dispatcher } = node;
  const covered = side === "EAST" && !node.open && node.ports.length > 0 ? 14 : 0;
  context.textBaseline = "middle";
  context.fillStyle = look.active ? colours["active-ink"] : colours.ink;
  if (dispatcher !== undefined) {
    context.font = `650 14px ${sans}`;
    context.textAlign = "center";
    context.fillStyle = colours.oracle;
    context.fillText(kSigns[dispatcher], x + (width - (side === "EAST" ? 14 : 0)) / 2, y + (height - (side === "EAST" ? 0 : 14)) / 2);
    context.textAlign = "left";
    return;
  }
  const middle = y + headHeight(zoom) / 2;
  const margin = zoom >= 0.62 ? 11 : 8;
  const badgeSize = badge === undefined ? 0 : badge.length * 5.6 + 20;
  context.font = `650 ${size}px ${sans}`;
  const name = fittingName(node.name, size, width - margin - 4 - covered - (composite ? 22 : 0) - badgeSize);
  context.fillText(name, x + margin, middle);
  if (badge !== undefined && 10 * zoom >= 4.5) {
    const oracle = badge.startsWith("oracle");
    const left = x + margin + context.measureText(name).width + 8;
    context.font = `10px ${sans}`;
    context.fillStyle = oracle ? colours["oracle-soft"] : colours["accent-soft"];
    context.beginPath();
    context.roundRect(left, middle - 7.5, context.measureText(badge).width + 12, 15, oracle ? 7 : 4);
    context.fill();
    context.fillStyle = oracle ? colours.oracle : colours.accent;
    context.fillText(badge, left + 6, middle);
  }
  if (!composite || 17 * zoom < 6) return;
  const box = toggleBox(node, zoom);
  context.beginPath();
  context.roundRect(box.x, box.y, box.width, box.height, 5);
  context.fillStyle = colours.panel;
  context.fill();
  context.strokeStyle = colours["edge-strong"];
  context.lineWidth = 1;
  context.stroke();
  context.font = `13px ${sans}`;
  context.textAlign = "center";
  context.fillStyle = colours.soft;
  context.fillText(node.open ? "−" : "+", box.x + box.width / 2, box.y + box.height / 2);
  context.textAlign = "left";
}

function paintText(context: Context, node: DrawnNode, theme: Theme, look: NodeLook): void {
  const { colours, sans, mono } = theme;
  const top = node.y + 30;
  context.strokeStyle = look.active ? colours["active-edge"] : colours.edge;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(node.x + 1, top);
  context.lineTo(node.x + node.width - 1, top);
  context.stroke();
  node.lines.forEach((line, i) => {
    const middle = top + 5 + i * 16 + 8;
    if (node.lines[i - 1]?.label !== line.label) {
      context.font = `10px ${sans}`;
      context.fillStyle = colours.faint;
      context.fillText(line.label, node.x + 11, middle);
    }
    context.font = `10px ${mono}`;
    context.fillStyle = colours.ink;
    context.fillText(line.text, node.x + 57, middle);
    const value = look.value(line);
    if (value === undefined) return;
    const left = node.x + 57 + context.measureText(line.text).width;
    context.font = `600 10px ${mono}`;
    context.fillStyle = colours["active-ink"];
    context.fillText(` = ${value}`, left, middle, Math.max(10, node.x + node.width - 4 - left));
  });
}

function paintBarrier(context: Context, { x, y, width, height }: DrawnNode, zoom: number, theme: Theme, { active, waiting }: NodeLook): void {
  const { colours, sans } = theme;
  if (active) {
    context.fillStyle = colours["active-glow"];
    context.fillRect(x - 4, y - 4, width + 8, height + 8);
  }
  context.fillStyle = waiting !== undefined ? colours.wait : active ? colours.active : colours.solid;
  context.fillRect(x, y, width, height);
  if (waiting === undefined || 11 * zoom < 4.5) return;
  context.font = `650 11px ${sans}`;
  const wide = context.measureText(waiting).width + 12;
  context.beginPath();
  context.roundRect(x + (width - wide) / 2, y - 20, wide, 16, 6);
  context.fillStyle = colours["wait-soft"];
  context.fill();
  context.fillStyle = colours["wait-ink"];
  context.textBaseline = "middle";
  context.fillText(waiting, x + (width - wide) / 2 + 6, y - 12);
}

/** The node without what is in it: of an open composite that is painted over its inside (`above`), the frame and the row of its name. */
export function paintNode(context: Context, node: DrawnNode, zoom: number, theme: Theme, look: NodeLook, above = false): void {
  context.setLineDash([]);
  if (node.kind === "barrier") {
    paintBarrier(context, node, zoom, theme, look);
    return;
  }
  const { fill, border } = surface(node, look, theme);
  const hollow = above && node.open && showsInside(node, zoom);
  const leaf = !node.open;
  if (look.active && leaf && zoom >= 0.3) {
    frame(context, node, zoom);
    context.strokeStyle = theme.colours["active-glow"];
    context.lineWidth = 5.4;
    context.stroke();
  }
  frame(context, node, zoom);
  if (hollow) {
    // What was written there before is painted over.
    context.fillStyle = fill;
    const text = node.lines.length > 0 && showsCode(zoom) ? node.lines.length * 16 + 9 : 0;
    if (nameSize(node, zoom) > 0) context.fillRect(node.x + 4, node.y + 2, node.width - 8, headHeight(zoom) - 4 + text);
  } else {
    context.fillStyle = node.open && !showsInside(node, zoom) && !look.active && !look.faulted ? theme.colours["minimap-node"] : fill;
    context.fill();
  }
  context.strokeStyle = border;
  context.lineWidth = Math.max(look.active && node.open ? 1.8 : 1.4, (look.active || look.faulted ? 1.4 : 0.5) / zoom);
  context.stroke();
  if (!node.open || showsInside(node, zoom)) {
    paintHead(context, node, zoom, theme, look);
    if (node.lines.length > 0 && showsCode(zoom)) paintText(context, node, theme, look);
  }
  if (showsPorts(node, zoom)) for (const port of node.ports) paintPort(context, port, node, zoom, theme, look.port(port.address));
}
