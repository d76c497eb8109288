// What a depth camera sees, as coloured points in o, from a packet with a picture, its pinhole and where the camera stands (services/camera).
import type { Packet, Pose, Vector } from "../../generated/messages";
import { bytes } from "../service/pixels";

export interface Cloud {
  /** [s] When it was so. */
  readonly time: number;
  readonly count: number;
  /** x, y, z of each point [m, in o]. */
  readonly positions: Float32Array;
  /** Red, green, blue of each point, 8 bit each. */
  readonly colours: Uint8Array;
}

/** More would be too slow to draw without a GPU; of larger pictures every second, third … pixel in both directions is taken. */
export const kMostPoints = 20_000;

interface Camera {
  /** Of the whole picture, of which packets have a smaller one [pixels]. */
  readonly width: number;
  readonly fx: number;
  readonly fy: number;
  readonly cx: number;
  readonly cy: number;
  readonly o_t_c: Pose;
}

const isNumbers = (value: unknown, count: number): boolean => Array.isArray(value) && value.length === count && value.every((each) => Number.isFinite(each));

function cameraOf(header: unknown): Camera | undefined {
  if (typeof header !== "object" || header === null) return undefined;
  const { width, fx, fy, cx, cy, o_t_c: pose } = header as { readonly [K in keyof Camera]?: unknown };
  if (!isNumbers([width, fx, fy, cx, cy], 5) || typeof pose !== "object" || pose === null) return undefined;
  const { position, orientation } = pose as { readonly [K in keyof Pose]?: unknown };
  return isNumbers(position, 3) && isNumbers(orientation, 4) ? (header as Camera) : undefined;
}

/** The columns of the rotation of a unit quaternion [qx, qy, qz, qw]. */
function axes([x, y, z, w]: Pose["orientation"]): readonly [Vector, Vector, Vector] {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
}

/** The measured points of a packet; nothing if it has no picture, or does not say how and from where it was taken. */
export function cloudOf({ time, header, picture }: Packet): Cloud | undefined {
  const camera = cameraOf(header);
  if (picture === undefined || camera === undefined) return undefined;
  const { width, height } = picture;
  const shrink = camera.width / width;
  const every = Math.max(1, Math.ceil(Math.sqrt((width * height) / kMostPoints)));
  const most = Math.ceil(width / every) * Math.ceil(height / every);
  const positions = new Float32Array(3 * most);
  const colours = new Uint8Array(3 * most);
  const depths = bytes(picture.depth);
  const rgb = bytes(picture.colour);
  const [right, down, ahead] = axes(camera.o_t_c.orientation);
  const { position } = camera.o_t_c;
  let count = 0;
  for (let row = 0; row < height; row += every) {
    for (let column = 0; column < width; column += every) {
      const pixel = row * width + column;
      const z = ((depths[2 * pixel] ?? 0) | ((depths[2 * pixel + 1] ?? 0) << 8)) / 1000;
      if (z === 0) continue;
      // The depth of a square is that of its first measured pixel, at its top left.
      const x = ((column * shrink - camera.cx) / camera.fx) * z;
      const y = ((row * shrink - camera.cy) / camera.fy) * z;
      for (const i of [0, 1, 2] as const) {
        positions[3 * count + i] = position[i] + x * right[i] + y * down[i] + z * ahead[i];
        colours[3 * count + i] = rgb[3 * pixel + i] ?? 0;
      }
      count++;
    }
  }
  return { time, count, positions: positions.subarray(0, 3 * count), colours: colours.subarray(0, 3 * count) };
}
