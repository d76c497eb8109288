// Levels of detail: what of a drawing is painted at which zoom. The sizes of names are those of the style sheet (canvas.css).
import { clip } from "../model/describe";
import type { Box, DrawnNode, DrawnPort } from "./drawing";
import { nameRoom, nameWidth, portNameRoom } from "./measure";

/** Smaller text cannot be read, so it is not painted [px of the screen]. */
const kLegible = 4.5;
/** A state smaller than this is a filled box without its inside [px of the screen]. */
const kInside = 26;
/** Ports lower than this are not painted [px of the screen]. */
const kPort = 2.5;
/** Below this zoom names are enlarged, and code is left out. */
export const kFar = 0.62;

const kName = 13;
const kPortName = 11;

/** From this zoom on, the names of ports are 10 px high or higher. */
export const kPortsLegible = 10 / kPortName;

/** By how much names are enlarged at most, and how much is readable at least. */
const growthAt = (zoom: number) => ({ grow: Math.min(3, 0.72 / zoom), least: 0.5 / zoom });

/** The size of a state's name, in the drawing; 0 if it could not be read. */
export function nameSize(node: DrawnNode, zoom: number): number {
  const { grow, least } = growthAt(zoom);
  const size = zoom >= kFar ? kName : kName * Math.max(Math.min(grow, nameRoom(node)), Math.min(grow, least));
  return size * zoom < kLegible ? 0 : size;
}

/** The same of a port. */
export function portNameSize(port: DrawnPort, zoom: number): number {
  const size = zoom >= kFar ? kPortName : kPortName * Math.min(growthAt(zoom).grow, portNameRoom(port), 1.3);
  return size * zoom < kLegible ? 0 : size;
}

/** The height of the row with a state's name. */
export const headHeight = (zoom: number): number => (zoom >= kFar ? 30 : 30 * Math.min(growthAt(zoom).grow, 1.5));

export const showsCode = (zoom: number): boolean => zoom >= kFar;

export const showsPorts = ({ ports }: DrawnNode, zoom: number): boolean => Math.min(ports[0]?.height ?? 0, ports[0]?.width ?? 0) * zoom >= kPort;

/** Whether what is in a composite of this size is painted; else it is a filled box. */
export const showsInside = ({ width, height }: Pick<Box, "width" | "height">, zoom: number): boolean => Math.min(width, height) * zoom >= kInside;

/** As much of a name as fits, with `…` for the rest. */
export function fittingName(name: string, size: number, width: number): string {
  if (nameWidth(name, size) <= width) return name;
  let end = name.length;
  while (end > 1 && nameWidth(clip(name, end), size) > width) end--;
  return end > 1 ? clip(name, end) : "";
}
