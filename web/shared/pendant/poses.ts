// Taught poses: where the arm stood when somebody saved it, by name in the database (api/skills.md).
import { isObject, type JsonValue } from "../json";
import { kJoints } from "../control/jog";

/** Of the keys in the database. */
export const kPosePrefix = "pose_";
/** So many are read and listed; what is more is in the database all the same. */
export const kMostPoses = 100;

export interface TaughtPose {
  readonly name: string;
  /** Of the arm [rad]. */
  readonly q: readonly number[];
}

/** Whether a pose can have this name. */
export const isPoseName = (name: string): boolean => /^[A-Za-z0-9_-]{1,32}$/.test(name);

export const keyOfPose = (name: string): string => `${kPosePrefix}${name}`;

/** The names of all poses among keys of the database; in order, as people count. */
export const poseNames = (keys: JsonValue): readonly string[] =>
  !Array.isArray(keys)
    ? []
    : keys
        .flatMap((key: unknown) => (typeof key === "string" && key.startsWith(kPosePrefix) && isPoseName(key.slice(kPosePrefix.length)) ? [key.slice(kPosePrefix.length)] : []))
        .sort((a, b) => a.localeCompare(b, "en", { numeric: true }));

/** The joints of a pose as the database has it; nothing: it has none that the arm can go to. */
export function readPose(name: string, value: JsonValue): TaughtPose | undefined {
  const q: unknown = isObject(value) ? value["q"] : undefined;
  if (!Array.isArray(q) || q.length !== kJoints) return undefined;
  const angles = q.filter((angle: unknown): angle is number => typeof angle === "number" && Number.isFinite(angle));
  return angles.length === kJoints ? { name, q: angles } : undefined;
}

/** A name that no pose has: `pose1`, `pose2`. */
export function freeName(names: readonly string[], stem = "pose"): string {
  for (let number = 1; ; number++) if (!names.includes(`${stem}${number}`)) return `${stem}${number}`;
}

/** x, y, z in `o` [m]. */
export type Position = readonly [number, number, number];

/** Where the tool is in a pose as the database has it, or in the state of a robot. */
export function positionIn(value: JsonValue): Position | undefined {
  const pose: unknown = isObject(value) ? value["pose"] : undefined;
  const position: unknown = typeof pose === "object" && pose !== null && "position" in pose ? pose.position : undefined;
  if (!Array.isArray(position) || position.length !== 3) return undefined;
  const [x, y, z] = position.filter((each: unknown): each is number => typeof each === "number" && Number.isFinite(each));
  return x !== undefined && y !== undefined && z !== undefined ? [x, y, z] : undefined;
}
