// Whether the arm of the cell moves, by the poses that the server streams.
import { NodeSocket } from "./nodeSocket";

/** Between two poses, a joint that moves turns by more [rad]. */
const kStanding = 1e-3;

type Joints = Readonly<Record<string, number>>;

export interface Arm {
  readonly moves: () => boolean;
  readonly close: () => void;
}

/** Requires a server without accounts. `standing`: an arm whose joints turn by no more between two poses stands [rad]. */
export function watchArm(url: string, standing = kStanding): Arm {
  const socket = new NodeSocket(`${url.replace(/^http/, "ws")}/api/v1/stream`);
  let before: Joints = {};
  let isMoving = false;
  socket.onopen = () => socket.send(JSON.stringify({ type: "subscribe", channel: "cell/pose" }));
  socket.onmessage = ({ data }) => {
    for (const message of [JSON.parse(data) as unknown].flat() as readonly { readonly channel: string; readonly data: { readonly joints?: Joints } }[]) {
      const { joints } = message.data;
      if (message.channel !== "cell/pose" || joints === undefined) continue;
      isMoving = Object.entries(joints).some(([name, at]) => Math.abs(at - (before[name] ?? at)) > standing);
      before = joints;
    }
  };
  return { moves: () => isMoving, close: () => socket.close() };
}
