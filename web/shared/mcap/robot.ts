// The frames of the links of a robot: each joint places a link in the one before, by its recorded position.
import type { CellPose, Pose } from "../../generated/messages";
import { product, rotated, turn, type Vector } from "./rotation";

/** A joint of a URDF. */
export interface Joint {
  readonly name: string;
  readonly kind: "fixed" | "turns" | "slides";
  readonly parent: string;
  readonly child: string;
  /** Where the child is in the parent at 0. */
  readonly origin: Pose;
  /** In the frame of the child. */
  readonly axis: Vector;
}

export interface Robot {
  /** Of its root link, in the world. */
  readonly base: Pose;
  readonly root: string;
  readonly joints: readonly Joint[];
}

export interface Frame {
  readonly parent: string;
  readonly child: string;
  readonly pose: Pose;
}

/** The frame in which the cell is given. */
export const kWorld = "world";

function placed({ kind, origin, axis }: Joint, at: number): Pose {
  if (kind === "fixed") return origin;
  if (kind === "turns") return { position: origin.position, orientation: product(origin.orientation, turn(axis, at)) };
  const way = at / Math.hypot(...axis);
  const [x, y, z] = rotated(origin.orientation, [axis[0] * way, axis[1] * way, axis[2] * way]);
  const [ox, oy, oz] = origin.position;
  return { position: [ox + x, oy + y, oz + z], orientation: origin.orientation };
}

/** The joints whose position must be recorded. */
export const movingJoints = ({ joints }: Robot): readonly string[] => joints.filter(({ kind }) => kind !== "fixed").map(({ name }) => name);

/** Of all links; nothing: the position of a joint is not recorded, so it may be another robot. */
export function linkFrames(robot: Robot, positions: CellPose["joints"]): readonly Frame[] {
  if (!movingJoints(robot).every((name) => Object.hasOwn(positions, name))) return [];
  const links = robot.joints.map((joint) => ({ parent: joint.parent, child: joint.child, pose: placed(joint, positions[joint.name] ?? 0) }));
  return [{ parent: kWorld, child: robot.root, pose: robot.base }, ...links];
}
