// Sizes of what is drawn, from the length of its text: the fonts of the drawing have known widths, so no browser is asked.
import { clip, describeState, type Line } from "../model/describe";
import type { Port, State } from "../model/model";
import type { Box, Side } from "./drawing";

const kTextLimit = 34;
const kWideLimit = 58;
const kHeader = 30;
const kLineHeight = 16;
const kMonoWidth = 6.05;
const kNameWidth = 7.6;
const kLabelWidth = 50;
const kPortHeight = 29;
const kSlimPortHeight = 20;
const kPortGap = 8;
const kPortInset = 14;
export const kBarrier = { thickness: 8, length: 74 };

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
  if (detail !== "full") return [];
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

/** The name and the text section beneath it. */
export function headSize(state: State, detail: Detail): Size {
  const lines = drawnLines(state, detail);
  const widest = Math.max(0, ...lines.map((line) => kLabelWidth + line.text.length * kMonoWidth));
  const badge = state.link === undefined && state.oracle === undefined ? 0 : 60;
  return {
    width: Math.ceil(Math.max(96, state.name.length * kNameWidth + 44 + badge, widest + 24)),
    height: kHeader + (lines.length === 0 ? 0 : lines.length * kLineHeight + 10),
  };
}

/** How long a condition may be where its port stands: enough to tell `svc.gripper.release.result` from `.error`. */
const kConditionLimit = 28;

export function conditionText(port: Port): string {
  return clip(port.when, kConditionLimit);
}

export function portSize(port: Port, detail: Detail): Size {
  const condition = detail === "slim" ? 0 : conditionText(port).length * kMonoWidth;
  return {
    width: Math.ceil(Math.max(54, port.name.length * 6.7 + 16, condition + 16)),
    height: detail === "slim" ? kSlimPortHeight : kPortHeight,
  };
}

/** How far a port reaches into its state: it stands on the border, most of it outside. */
export const portInset = kPortInset;

/** A state that is drawn without children: its size and the place of each port on its border. */
export function leafBoxes(state: State, side: Side, detail: Detail): { readonly size: Size; readonly ports: readonly Box[] } {
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
