// How hands and removed parts are shown.
import type { Body, CellPose, Touch, Vector } from "../../generated/messages";

const kPushLength = 0.002; // m of the drawn line for each newton of a push

/** How strong a force is, as "25 N". */
export const forceText = ({ force }: Touch): string => `${Math.hypot(...force).toFixed(0)} N`;

/** The end of the line of a touch: the target of a hand, or a point along a push [m, in o]. */
export function lineEnd({ at, force, target }: Touch): Vector {
  return target ?? [at[0] + kPushLength * force[0], at[1] + kPushLength * force[1], at[2] + kPushLength * force[2]];
}

/** Names of the movable bodies that are not in the cell. */
export const absentParts = (bodies: readonly Body[], pose: CellPose): readonly string[] =>
  bodies.filter((body) => !body.fixed && !(body.name in pose.bodies)).map((body) => body.name);

/** The link of a robot that a hand pulls, if there is one: whatever it holds that is no body of the scene. */
export const pulledLink = (bodies: readonly Body[], { hands = [] }: CellPose): string | undefined =>
  hands.find(({ body, target }) => target !== undefined && bodies.every(({ name }) => name !== body))?.body;
