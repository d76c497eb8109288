// Rotations as unit quaternions [qx, qy, qz, qw], as far as the frames of a robot need them.
import type { Pose } from "../../generated/messages";

export type Vector = Pose["position"];
export type Quaternion = Pose["orientation"];

/** First `b`, then `a`. */
export const product = ([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): Quaternion => [
  aw * bx + ax * bw + ay * bz - az * by,
  aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw,
  aw * bw - ax * bx - ay * by - az * bz,
];

/** Around an axis, which needs no length of 1 but is not 0 [rad]. */
export function turn([x, y, z]: Vector, angle: number): Quaternion {
  const part = Math.sin(angle / 2) / Math.hypot(x, y, z);
  return [x * part, y * part, z * part, Math.cos(angle / 2)];
}

export function rotated(by: Quaternion, [x, y, z]: Vector): Vector {
  const [qx, qy, qz, qw] = by;
  const [rx, ry, rz] = product(product(by, [x, y, z, 0]), [-qx, -qy, -qz, qw]);
  return [rx, ry, rz];
}

/** Of the fixed axes X, Y, Z one after the other, as URDF has it [rad]. */
export const ofRollPitchYaw = ([roll, pitch, yaw]: Vector): Quaternion => product(turn([0, 0, 1], yaw), product(turn([0, 1, 0], pitch), turn([1, 0, 0], roll)));
