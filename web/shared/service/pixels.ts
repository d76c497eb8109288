// Pixels of a camera's picture in the format of a canvas: red, green, blue and opacity, 8 bit each.
import type { Picture } from "../../generated/messages";

export type ImageKind = "colour" | "depth";

/** The range of the false colours [mm]: that of the first Kinect. */
export const kNearest = 800;
export const kFarthest = 4000;
/** The colour of pixels that were not measured. */
const kUnmeasured = [38, 42, 41] as const;

type Rgb = readonly [number, number, number];

/** From near, warm and light, to far, cold and dark; the lightness is monotonic. */
const kStops: readonly Rgb[] = [
  [252, 230, 120],
  [244, 150, 70],
  [206, 75, 100],
  [120, 50, 130],
  [40, 40, 110],
];

/** The bytes of a text in base64. */
export function bytes(base64: string): Uint8Array {
  return Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
}

function mixed(depth: number): Rgb {
  const share = (Math.max(0, depth - kNearest) / (kFarthest - kNearest)) * (kStops.length - 1);
  const low = Math.min(kStops.length - 2, Math.floor(share));
  const [from, to] = [kStops[low] ?? kUnmeasured, kStops[low + 1] ?? kUnmeasured];
  const mix = (i: 0 | 1 | 2) => Math.round(from[i] + (to[i] - from[i]) * (share - low));
  return [mix(0), mix(1), mix(2)];
}

const kColours: readonly Rgb[] = Array.from({ length: kFarthest + 1 }, (_, depth) => (depth === 0 ? kUnmeasured : mixed(depth)));

/** The false colour of a depth [mm]; beyond the range it is that of its end. */
export function depthColour(depth: number): Rgb {
  return kColours[Math.min(depth, kFarthest)] ?? kUnmeasured;
}

/** The false colours from near to far, as CSS has them. */
export const depthScale = `linear-gradient(to right, ${kStops.map((rgb) => `rgb(${rgb.join(" ")})`).join(", ")})`;

/** All pixels; black where the picture has less data than its size needs. */
export function pixels(picture: Picture, kind: ImageKind): Uint8ClampedArray<ArrayBuffer> {
  const count = picture.width * picture.height;
  const rgba = new Uint8ClampedArray(count * 4).fill(255);
  const data = bytes(kind === "depth" ? picture.depth : picture.colour);
  for (let i = 0; i < count; i++) {
    const rgb = kind === "depth" ? depthColour((data[2 * i] ?? 0) | ((data[2 * i + 1] ?? 0) << 8)) : data.subarray(3 * i, 3 * i + 3);
    for (let c = 0; c < 3; c++) rgba[4 * i + c] = rgb[c] ?? 0;
  }
  return rgba;
}
