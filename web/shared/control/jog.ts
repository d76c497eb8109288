// A motion by hand: what a held button asks of the robot.
import type { HostedService } from "../../generated/messages";

export const kJoints = 7;
export type Axis = "x" | "y" | "z";
export const kAxes: readonly Axis[] = ["x", "y", "z"];
/** Of the origin of the cell, or of the tool. */
export type JogFrame = "o" | "tool";
export type Sign = 1 | -1;

export type JogPart = { readonly kind: "joint"; readonly joint: number } | { readonly kind: "linear"; readonly axis: Axis } | { readonly kind: "angular"; readonly axis: Axis };

export const kJointParts: readonly JogPart[] = Array.from({ length: kJoints }, (_, joint) => ({ kind: "joint", joint }));
export const kToolParts: readonly JogPart[] = [...kAxes.map((axis): JogPart => ({ kind: "linear", axis })), ...kAxes.map((axis): JogPart => ({ kind: "angular", axis }))];

/** `1`, `Joint 1`; `RX`, `Tool around X` */
export function partName(part: JogPart): { readonly short: string; readonly long: string } {
  if (part.kind === "joint") return { short: `${part.joint + 1}`, long: `Joint ${part.joint + 1}` };
  const axis = part.axis.toUpperCase();
  return part.kind === "linear" ? { short: axis, long: `Tool along ${axis}` } : { short: `R${axis}`, long: `Tool around ${axis}` };
}

/** A velocity, as `jog` of a robot takes it. */
export type Jog =
  | { readonly joints: readonly number[] }
  | { readonly linear: readonly number[]; readonly frame: JogFrame }
  | { readonly angular: readonly number[]; readonly frame: JogFrame };

/** At a share of 1 [rad/s, m/s, rad/s]: below what `jog` takes at most (services/robot). */
export const kFastest = { joint: 0.8, linear: 0.25, angular: 0.8 } as const;
export const kFirstShare = 0.1;
/** Of a slider. */
export const kShares = { least: 0.02, most: 1, step: 0.02 } as const;

const along = (place: number, places: number, value: number): readonly number[] => Array.from({ length: places }, (_, i) => (i === place ? value : 0));

/** The velocity of a part at a share of the fastest one. */
export function jogOf(part: JogPart, sign: Sign, share: number, frame: JogFrame): Jog {
  const speed = sign * kFastest[part.kind] * share;
  switch (part.kind) {
    case "joint":
      return { joints: along(part.joint, kJoints, speed) };
    case "linear":
      return { linear: along(kAxes.indexOf(part.axis), kAxes.length, speed), frame };
    case "angular":
      return { angular: along(kAxes.indexOf(part.axis), kAxes.length, speed), frame };
  }
}

/** The same, standing. */
export function standing(jog: Jog): Jog {
  if ("joints" in jog) return { joints: jog.joints.map(() => 0) };
  return "linear" in jog ? { ...jog, linear: [0, 0, 0] } : { ...jog, angular: [0, 0, 0] };
}

const degrees = (radians: number): number => (radians * 180) / Math.PI;

/** `10 %: 25 mm/s, 4.6 °/s` */
export const speedText = (share: number): string => `${Math.round(share * 100)} %: ${(kFastest.linear * share * 1000).toFixed(0)} mm/s, ${degrees(kFastest.angular * share).toFixed(1)} °/s`;

/** `-34.2°`; never `-0.0°`. */
export const angleText = (angle: number | undefined): string => (angle === undefined ? "–" : `${(Math.round(degrees(angle) * 10) / 10 + 0).toFixed(1)}°`);

/** The angles of an arm in a pose of the cell, by names that are numbered from 1 on, such as `a1` to `a7`; none: there is no such arm. */
export function armAngles(joints: Readonly<Record<string, number>>): readonly number[] {
  const prefixes = Object.keys(joints).flatMap((name) => (name.endsWith(`${kJoints}`) ? [name.slice(0, -1)] : []));
  for (const prefix of prefixes) {
    const angles = Array.from({ length: kJoints }, (_, i) => joints[`${prefix}${i + 1}`]).filter((angle) => angle !== undefined);
    if (angles.length === kJoints) return angles;
  }
  return [];
}

type Described = Pick<HostedService, "key" | "available" | "rsm">;

const offers = ({ available, rsm }: Described, ...operations: readonly string[]): boolean => available && operations.every((wanted) => rsm.operations.some(({ name }) => name === wanted));

/** What can be moved by hand. */
export interface Movable {
  /** The robot. */
  readonly robot: string | undefined;
  readonly gripper: { readonly key: string; readonly open: string; readonly close: string } | undefined;
}

/** Whether the robot gives way to a hand while a button is held. */
export const canGuide = (services: readonly Described[]): boolean => services.some((service) => offers(service, "guide", "stop"));

/** The robot whose motions can be slowed down while they go on. */
export const overridable = (services: readonly Described[]): string | undefined => services.find((service) => offers(service, "speed_override"))?.key;

export function movableOf(services: readonly Described[]): Movable {
  const hand = [{ open: "release", close: "grasp" }, { open: "open", close: "close" }].flatMap(({ open, close }) => {
    const found = services.find((service) => offers(service, open, close));
    return found === undefined ? [] : [{ key: found.key, open, close }];
  });
  return { robot: services.find((service) => offers(service, "jog", "stop"))?.key, gripper: hand[0] };
}
