// Where everything in the cell was, as messages: frames of links and bodies, and the positions of joints.
import type { CellPose, RunPicture } from "../../generated/messages";
import { stampOf, type McapChannel, type McapMessage } from "./message";
import { kWorld, linkFrames, type Frame, type Robot } from "./robot";

const kFrames: McapChannel = { topic: "/tf", schema: "foxglove.FrameTransforms" };
const kJoints: McapChannel = { topic: "/joint_states", schema: "foxglove.JointStates" };

/** The frame of a body: a link of a robot may have the same name. */
const frameOfBody = (name: string): string => `body/${name}`;

const xyz = ([x, y, z]: readonly [number, number, number]) => ({ x, y, z });

function transform({ parent, child, pose }: Frame, time: number): object {
  const [x, y, z, w] = pose.orientation;
  return { timestamp: stampOf(time), parent_frame_id: parent, child_frame_id: child, translation: xyz(pose.position), rotation: { x, y, z, w } };
}

/** At `time` [us] since 1970. */
export function poseMessages({ joints, bodies }: CellPose, time: number, robots: readonly Robot[]): readonly McapMessage[] {
  const ofBodies = Object.entries(bodies).map(([name, pose]): Frame => ({ parent: kWorld, child: frameOfBody(name), pose }));
  const frames = [...robots.flatMap((robot) => linkFrames(robot, joints)), ...ofBodies];
  return [
    { channel: kFrames, time, value: { transforms: frames.map((frame) => transform(frame, time)) } },
    { channel: kJoints, time, value: { timestamp: stampOf(time), joints: Object.entries(joints).map(([name, position]) => ({ name, position })) } },
  ];
}

export const pictureMessage = ({ service, jpeg }: Pick<RunPicture, "service" | "jpeg">, time: number): McapMessage => ({
  channel: { topic: `/images/${service}`, schema: "foxglove.CompressedImage" },
  time,
  value: { timestamp: stampOf(time), frame_id: service, data: jpeg, format: "jpeg" },
});
