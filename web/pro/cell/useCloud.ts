// What a depth camera sees, for the 3D view: its pictures are taken, and fetched, only while it is wanted.
import { useEffect, useEffectEvent, useState } from "react";
import { cloudOf, type Cloud } from "../../shared/cell/cloud";
import { useSession, watchFlow } from "../client";

/** The flow of pictures of a camera (services/camera). */
const kFrame = "frame";
/** Pictures that come sooner after the one that is drawn are left out [s]. */
const kPeriod = 0.35;

/** The key of the service that has a depth camera. */
export const useCamera = (): string | undefined => useSession(({ services }) => services.find(({ publishes, available }) => available && publishes.some(({ flow }) => flow === kFrame))?.key);

/** Shows the clouds of a camera, and in the end none; gives the number of points that are shown. */
export function useCloud(camera: string | undefined, show: (cloud: Cloud | undefined) => void): number | undefined {
  const [count, setCount] = useState<number>();
  const showed = useEffectEvent((cloud: Cloud | undefined) => {
    show(cloud);
    setCount(cloud?.count);
  });
  useEffect(() => {
    if (camera === undefined) return;
    let last = -Infinity;
    const end = watchFlow(camera, kFrame, (packet) => {
      if (packet.time >= last && packet.time < last + kPeriod) return;
      last = packet.time;
      showed(cloudOf(packet));
    });
    return () => {
      end();
      showed(undefined);
    };
  }, [camera]);
  return count;
}
