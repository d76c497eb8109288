// How often the cell is worth drawing: not when nothing has moved, and seldom where a frame takes long.
import type { CellPose, Pose } from "../../generated/messages";

/** A frame that takes longer is made without a GPU, by the processor that the rest of the page needs too [ms]. */
const kSlow = 25;
/** Even then the cell moves once in this time [ms]. */
const kLongest = 1000;

/** How long to rest after a frame that took so long, so that drawing gets at most a third of the time [ms]. */
export function restAfter(took: number): number {
  return took < kSlow ? 0 : Math.min(kLongest, 2 * took);
}

/** What is less is no pixel: angles [rad] and parts of a quaternion, and lengths [m]. */
const kTurn = 2e-4;
const kShift = 1e-4;

const apart = (a: readonly number[], b: readonly number[], limit: number): boolean => a.some((value, i) => Math.abs(value - (b[i] ?? Infinity)) > limit);

const moved = (a: Pose, b: Pose | undefined): boolean => b === undefined || apart(a.position, b.position, kShift) || apart(a.orientation, b.orientation, kTurn);

/** Whether two poses of a cell would give different pictures. Hands count as long as they hold: their lines follow the forces. */
export function looksDifferent(shown: CellPose, next: CellPose): boolean {
  const joints = Object.entries(next.joints);
  const bodies = Object.entries(next.bodies);
  return (
    [shown, next].some(({ hands = [] }) => hands.length > 0) ||
    bodies.length !== Object.keys(shown.bodies).length ||
    joints.some(([name, value]) => apart([value], [shown.joints[name] ?? Infinity], kTurn)) ||
    bodies.some(([name, pose]) => moved(pose, shown.bodies[name]))
  );
}
