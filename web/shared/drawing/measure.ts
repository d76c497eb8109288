// Sizes of what is drawn, from the length of its text: the fonts of the drawing have known widths, so no browser is needed.
import { clip, describeState, portText, type Line } from "../model/describe";
import type { Port, State } from "../model/model";
import type { Box, DrawnNode, DrawnPort, Side } from "./drawing";

const kTextLimit = 34;
const kWideLimit = 58;
const kHeader = 30;
const kLineHeight = 16;
const kMonoWidth = 6.05;
const kLabelWidth = 50;
const kPortHeight = 29;
const kSlimPortHeight = 20;
const kPortGap = 8;
const kPortInset = 14;
export const kBarrier = { thickness: 8, length: 74 };

/** Widths of characters in the font of names, for a size of 1 px: Inter, weights 600 and 650. Others are as wide as an M. */
const kWidths: readonly (readonly [characters: string, width: number])[] = [
  ["ijlI'!,.:;", 0.35],
  ["frt|()/[]\\` ", 0.43],
  ["-^_{}\"1", 0.54],
  ["aceosvxyzkLJF7*?", 0.62],
  ["235689bdghnpquESPT04BRZ&+<=>~#$", 0.69],
  ["ACGHNUVDKXY", 0.77],
  ["OQw", 0.87],
  ["m", 0.93],
];
const kWidest = 1.04;

/** How wide a name is at most [px], written in this size [px]. */
export function nameWidth(name: string, size: number): number {
  return size * Array.from(name).reduce((sum, character) => sum + (kWidths.find(([characters]) => characters.includes(character))?.[1] ?? kWidest), 0);
}

const kNameSize = 13;
/** When zoomed out, names are drawn larger than at zoom 1 (canvas.css), by at most this factor. */
const kGrowth = 1.25;
const kPortGrowth = 1.15;
const kPortNameSize = 11;
/** What else is in the row of a name when it is written large: its margins, and the button that opens the state. */
const kRowMargin = 15;
const kToggle = 20;
const kPortMargin = 10;

/** How much larger than at zoom 1 the name of a drawn state may be written so that all of it is seen. */
export function nameRoom({ name, width, composite, ports, side, open, badge }: DrawnNode): number {
  const covered = side === "EAST" && !open && ports.length > 0 ? kPortInset : 0;
  return (width - kRowMargin - covered - badgeWidth(badge) - (composite ? kToggle : 0)) / nameWidth(name, kNameSize);
}

/** The clock before the name of a port with a time-out, and the gap behind it: as wide as this times the size of the name. */
const kClock = 1.25;

/** How wide the name of a port is at most [px], with its clock. */
const portNameWidth = (name: string, timed: boolean, size: number): number => nameWidth(name, size) + (timed ? kClock * size : 0);

export function portNameRoom({ name, timed, width }: DrawnPort): number {
  return (width - kPortMargin) / portNameWidth(name, timed, kPortNameSize);
}

/** How much is written into the states: everything; names and ports with their conditions; names alone. */
export type Detail = "full" | "ports" | "slim";

/** From the least to the most. */
export const details: readonly Detail[] = ["slim", "ports", "full"];

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** The text section: one line each in a leaf; a composite is wide, so its lines of one label share a row. */
export function drawnLines(state: State, detail: Detail): readonly Line[] {
  if (detail !== "full" || state.dispatcher !== undefined) return [];
  const lines = describeState(state);
  if (state.children.length === 0) return lines.map((line) => ({ ...line, text: clip(line.text, kTextLimit) }));
  const labels = [...new Set(lines.map((line) => line.label))].filter((label) => label !== "action");
  const joined = labels.map((label): Line => ({
    label,
    text: lines.filter((line) => line.label === label).map((line) => line.text).join(",  "),
  }));
  const actions = lines.filter((line) => line.label === "action");
  return [...joined, ...actions].map((line) => ({ ...line, text: clip(line.text, kWideLimit) }));
}

const kBadgeLimit = 24;
const kBadgeCharacter = 5.6;

/** The note beside a state's name: its link, or its oracle. */
export function badgeText(state: State): string | undefined {
  if (state.link !== undefined) return `link ${state.link}`;
  return state.oracle === undefined ? undefined : clip(`oracle ${state.oracle}`, kBadgeLimit);
}

const badgeWidth = (badge: string | undefined): number => (badge === undefined ? 0 : badge.length * kBadgeCharacter + 20);

/** The name and the text section beneath it. */
export function headSize(state: State, detail: Detail): Size {
  const lines = drawnLines(state, detail);
  const widest = Math.max(0, ...lines.map((line) => kLabelWidth + line.text.length * kMonoWidth));
  const badge = badgeWidth(badgeText(state));
  return {
    width: Math.ceil(Math.max(96, nameWidth(state.name, kNameSize * kGrowth) + 44 + badge, widest + 24)),
    height: kHeader + (lines.length === 0 ? 0 : lines.length * kLineHeight + 10),
  };
}

/** The longest condition or time-out beside a port: enough to tell `svc.gripper.release.result` from `.error`. */
const kConditionLimit = 28;

export function conditionText(port: Port): string {
  return clip(portText(port), kConditionLimit);
}

export function portSize(port: Port, detail: Detail): Size {
  const condition = detail === "slim" ? 0 : conditionText(port).length * kMonoWidth;
  const name = portNameWidth(port.name, port.after !== undefined, kPortNameSize * (detail === "slim" ? kPortGrowth : 1));
  return {
    width: Math.ceil(Math.max(54, name + 16, condition + 16)),
    height: detail === "slim" ? kSlimPortHeight : kPortHeight,
  };
}

/** How far a port reaches into its state: it is on the border, most of it outside. */
export const portInset = kPortInset;

/** Across, and along the border. */
const kDot = { depth: 20, length: 12, gap: 5 };
const kDispatcher = 40;

/** A dispatcher is a round sign with a dot for each port; the targets show their names. */
function dispatcherBoxes(state: State, side: Side): { readonly size: Size; readonly ports: readonly Box[] } {
  const pitch = kDot.length + kDot.gap;
  const length = Math.max(kDispatcher, state.ports.length * pitch + kDot.gap);
  const start = (length - state.ports.length * pitch + kDot.gap) / 2;
  const inset = kDispatcher - kPortInset;
  const dot = (_: Port, i: number): Box =>
    side === "EAST"
      ? { x: inset, y: start + i * pitch, width: kDot.depth, height: kDot.length }
      : { x: start + i * pitch, y: inset, width: kDot.length, height: kDot.depth };
  const size = side === "EAST" ? { width: kDispatcher, height: length } : { width: length, height: kDispatcher };
  return { size, ports: state.ports.map(dot) };
}

/** A state that is drawn without children: its size and the place of each port on its border. */
export function leafBoxes(state: State, side: Side, detail: Detail): { readonly size: Size; readonly ports: readonly Box[] } {
  if (state.dispatcher !== undefined) return dispatcherBoxes(state, side);
  const head = headSize(state, detail);
  const sizes = state.ports.map((port) => portSize(port, detail));
  if (side === "EAST") {
    const stack = sizes.reduce((sum, size) => sum + size.height + kPortGap, 0);
    const height = Math.max(head.height + 8, stack + kPortGap + 4, 44);
    const start = Math.max(kPortGap, (height - stack + kPortGap) / 2);
    const place = (i: number) => start + sizes.slice(0, i).reduce((sum, size) => sum + size.height + kPortGap, 0);
    const width = head.width + (sizes.length > 0 ? kPortInset : 0);
    return { size: { width, height }, ports: sizes.map((size, i) => ({ ...size, x: width - kPortInset, y: place(i) })) };
  }
  const row = sizes.reduce((sum, size) => sum + size.width + kPortGap, kPortGap);
  const width = Math.max(head.width, row);
  const start = (width - row) / 2 + kPortGap;
  const place = (i: number) => start + sizes.slice(0, i).reduce((sum, size) => sum + size.width + kPortGap, 0);
  const height = head.height + 6 + (sizes.length > 0 ? kPortInset : 0);
  return { size: { width, height }, ports: sizes.map((size, i) => ({ ...size, x: place(i), y: height - kPortInset })) };
}

export function barrierSize(side: Side): Size {
  return side === "EAST"
    ? { width: kBarrier.thickness, height: kBarrier.length }
    : { width: kBarrier.length, height: kBarrier.thickness };
}
