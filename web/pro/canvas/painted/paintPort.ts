// A port on a canvas, as PortBox draws it.
import type { DrawnNode, DrawnPort } from "../../../shared/drawing/drawing";
import { fittingName, portNameSize, showsCode } from "../../../shared/drawing/levels";
import type { Context } from "./context";
import type { Theme } from "./theme";

/** How a port looks now. */
export interface PortLook {
  readonly active: boolean;
  /** The run ended through it, and badly. */
  readonly endsBadly: boolean;
  /** Its time runs. */
  readonly waits: boolean;
  readonly faulted: boolean;
}

function paintClock(context: Context, x: number, y: number, size: number, colour: string): void {
  const radius = size * 0.42;
  context.strokeStyle = colour;
  context.lineWidth = size * 0.1;
  context.beginPath();
  context.arc(x + radius, y, radius, 0, 2 * Math.PI);
  context.moveTo(x + radius, y - radius * 0.6);
  context.lineTo(x + radius, y);
  context.lineTo(x + radius * 1.4, y + radius * 0.3);
  context.stroke();
}

export function paintPort(context: Context, port: DrawnPort, { dispatcher }: DrawnNode, zoom: number, theme: Theme, look: PortLook): void {
  const { colours, sans, mono } = theme;
  const { x, y, width, height, condition, timed } = port;
  context.beginPath();
  if (dispatcher === undefined) context.rect(x, y, width, height);
  else context.roundRect(x, y, width, height, Math.min(width, height) / 2);
  context.fillStyle = look.endsBadly ? colours.bad : look.active ? colours.fired : look.faulted ? colours["bad-soft"] : port.exits ? colours.inset : colours.panel;
  context.fill();
  context.strokeStyle = look.endsBadly ? colours.bad : look.active ? colours.active : look.faulted ? colours.bad : colours.outline;
  context.lineWidth = Math.max(1.3, 0.5 / zoom);
  context.stroke();
  if (dispatcher !== undefined) return;
  const size = portNameSize(port, zoom);
  if (size === 0) return;
  const near = showsCode(zoom);
  const margin = near ? 8 : 4;
  const clock = timed ? size * 1.25 : 0;
  const both = near && condition !== "";
  const middle = y + height / 2 - (both ? 6 : 0);
  const isFilled = look.active || look.endsBadly;
  const text = look.endsBadly ? colours["on-fill"] : look.active ? colours["on-fired"] : colours.ink;
  if (timed) paintClock(context, x + margin, middle, size, isFilled ? text : look.waits ? colours.wait : colours.soft);
  context.textBaseline = "middle";
  context.font = `600 ${size}px ${sans}`;
  context.fillStyle = text;
  context.fillText(fittingName(port.name, size, width - margin - 3 - clock), x + margin + clock, middle);
  if (!both) return;
  context.font = `10px ${mono}`;
  context.fillStyle = isFilled ? text : colours.soft;
  context.fillText(condition, x + margin, middle + 12.5);
}
