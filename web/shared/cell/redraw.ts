// When to redraw the cell: not if nothing has moved, and seldom if a frame takes long.
import type { CellPose, Pose } from "../../generated/messages";

/** A slower frame is rendered without a GPU, by the CPU that the rest of the page needs [ms]. */
const kSlow = 25;
/** The longest pause [ms]. */
const kLongest = 1000;

/** The pause after a frame that `took` so long, so that drawing gets at most a third of the time [ms]. */
export function pauseAfter(took: number): number {
  return took < kSlow ? 0 : Math.min(kLongest, 2 * took);
}

/** Smaller changes are not visible: angles [rad] and parts of a quaternion, and lengths [m]. */
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
