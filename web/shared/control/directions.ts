// Words for the ways in which the robot is moved by hand, for people who do not know its axes; and the names of its joints.
import type { HostedService } from "../../generated/messages";
import { kJoints, movableOf, partName, type Axis, type JogFrame, type JogPart, type Sign } from "./jog";

type Words = readonly [plus: string, minus: string];

/** As seen from the base of the robot, which looks along X: Y leads to its left, Z up. A turn is named by where the upper or the front side goes. */
const kOfCell: Readonly<Record<"linear" | "angular", Readonly<Record<Axis, Words>>>> = {
  linear: { x: ["Forward", "Back"], y: ["Left", "Right"], z: ["Up", "Down"] },
  angular: { x: ["Tilt right", "Tilt left"], y: ["Tip forward", "Tip back"], z: ["Turn left", "Turn right"] },
};
/** Along the tool, whose Z leads where it points; to its sides there are no words that hold for all. */
const kOfTool: Readonly<Record<"linear" | "angular", Readonly<Partial<Record<Axis, Words>>>>> = {
  linear: { z: ["Ahead", "Back off"] },
  angular: { z: ["Twist right", "Twist left"] },
};

/** Where a button leads; nothing: its sign says no less. */
export function wayOf(part: JogPart, sign: Sign, frame: JogFrame): string | undefined {
  if (part.kind === "joint") return undefined;
  return (frame === "o" ? kOfCell : kOfTool)[part.kind][part.axis]?.[sign > 0 ? 0 : 1];
}

/** `Up, tool along Z plus` */
export function wayName(part: JogPart, sign: Sign, frame: JogFrame, joints: readonly string[] = []): string {
  const long = `${partName(part).long} ${sign > 0 ? "plus" : "minus"}`;
  const word = part.kind === "joint" ? joints[part.joint] : wayOf(part, sign, frame);
  return word === undefined ? long : `${word}, ${long.charAt(0).toLowerCase()}${long.slice(1)}`;
}

/** The names of the joints of the robot that is moved, if its description has them: `meta.joints`, a text for each. */
export function jointNames(services: readonly Pick<HostedService, "key" | "available" | "rsm">[]): readonly string[] {
  const { robot } = movableOf(services);
  const meta: unknown = services.find(({ key }) => key === robot)?.rsm.meta;
  const joints: unknown = typeof meta === "object" && meta !== null && "joints" in meta ? meta.joints : undefined;
  if (!Array.isArray(joints) || joints.length !== kJoints) return [];
  const names = joints.filter((name: unknown): name is string => typeof name === "string" && name.trim() !== "");
  return names.length === kJoints ? names : [];
}
