// How an arm is controlled, as it says in its flow `control` (services/robot): whether it gives way, and what it felt.
import type { Packet } from "../../generated/messages";

/** The flow by which a robot tells it. */
export const kControl = "control";

export type Mode = "position" | "joint_impedance" | "cartesian_impedance" | "gravity_compensation";

export interface Collision {
  /** The outermost link whose joint felt it: it was there or farther out. */
  readonly link: string;
  readonly severity: string;
  /** What the robot did by itself, or `none`. */
  readonly reaction: string;
  /** Estimated as if it acted at the tool [N, in o]. */
  readonly f_ext_hat: readonly number[];
  /** [s] */
  readonly time: number;
}

export interface Control {
  /** [s] */
  readonly time: number;
  readonly mode: Mode;
  readonly moving: boolean;
  /** What a Cartesian spring pulls with at most [N]. */
  readonly force?: number;
  /** The last one. */
  readonly collision?: Collision;
}

const kModes: ReadonlySet<unknown> = new Set<Mode>(["position", "joint_impedance", "cartesian_impedance", "gravity_compensation"]);

const isCollision = (value: unknown): value is Collision => {
  if (typeof value !== "object" || value === null) return false;
  const { link, severity, reaction, f_ext_hat: force, time } = value as { readonly [K in keyof Collision]?: unknown };
  return [link, severity, reaction].every((text) => typeof text === "string") && typeof time === "number" && Array.isArray(force) && force.every((each) => typeof each === "number");
};

/** What a packet of the flow says; nothing if it is of another kind. */
export function controlOf({ time, header }: Packet): Control | undefined {
  if (typeof header !== "object" || header === null) return undefined;
  const { mode, moving, force, collision } = header as { readonly [K in keyof Control]?: unknown };
  if (!kModes.has(mode) || typeof moving !== "boolean") return undefined;
  return { time, mode: mode as Mode, moving, ...(typeof force === "number" && { force }), ...(isCollision(collision) && { collision }) };
}

/** How long a collision is marked after it was felt [s of world time]. */
export const kMarked = 10;

/** The collision that is marked now. */
export function markedCollision({ time, collision }: Control): Collision | undefined {
  return collision !== undefined && time >= collision.time && time - collision.time <= kMarked ? collision : undefined;
}

/** A collision in words: where it can have been, and how strong it was, which is only known as if the tool had met it. */
export function collisionText({ link, severity, f_ext_hat: force }: Collision): string {
  return `Collision felt at ${link} or beyond: ${severity}, ${Math.hypot(...force).toFixed(0)} N if at the tool`;
}

/** Why an arm that a hand pulls does not go with it; nothing: it does. */
export function whyItHolds(control: Control): string | undefined {
  const { mode, moving, force } = control;
  switch (mode) {
    case "gravity_compensation":
      return undefined;
    case "joint_impedance":
      return "The arm gives way like a spring, and goes back: the task has asked for joint_impedance.";
    case "cartesian_impedance":
      return `The arm gives way like a spring, and goes back${force === undefined ? "" : ` with at most ${force} N`}: the task has asked for cartesian_impedance.`;
    case "position": {
      const braked = markedCollision(control)?.reaction === "stop" ? "The arm has braked after a collision. " : "";
      const holds = moving ? "The arm follows its path and stops if it is pushed off it" : "The arm holds its position";
      return `${braked}${holds}: the task has not asked it to give way (gravity_compensation, or an impedance).`;
    }
  }
}
