// Where the tool is, while somebody looks at it.
import { useEffect, useState } from "react";
import { movableOf } from "../../shared/control/jog";
import { positionIn, type Position } from "../../shared/pendant/poses";
import { bystander } from "../client";
import { hand } from "../hand";

/** Between two questions [ms]. */
const kPause = 250;

/** In `o` [m]; nothing: it is not known. */
export function useTool(): Position | undefined {
  const { robot } = movableOf(hand.useServices());
  const [position, setPosition] = useState<Position>();
  useEffect(() => {
    if (robot === undefined) return undefined;
    let timer: ReturnType<typeof setTimeout> | undefined;
    let isOver = false;
    const ask = async (): Promise<void> => {
      const state = await bystander.callService(robot, "state", {}).catch(() => null);
      if (isOver) return;
      setPosition(positionIn(state));
      timer = setTimeout(() => void ask(), kPause);
    };
    void ask();
    return () => {
      isOver = true;
      clearTimeout(timer);
    };
  }, [robot]);
  return position;
}

/** [m] in millimetres. */
export const inMillimetres = (metres: number): string => `${Math.round(metres * 1000) + 0}`;
