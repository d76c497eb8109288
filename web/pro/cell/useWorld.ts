// The scene of the cell: loaded when its world is available, and again after each interruption, as it may be another world; what fails is tried again.
import { useEffect, useState } from "react";
import type { Body } from "../../generated/messages";
import { loadInAttempts } from "../../shared/cell/attempts";
import { cellUnavailable } from "../../shared/session/session";
import { access, api, useSession } from "../client";
import type { RobotModel } from "../../cell/CellScene";
import { messageOf } from "../../shared/messageOf";

export interface World {
  readonly bodies: readonly Body[];
  readonly robots: readonly RobotModel[];
}

async function textOf(file: string): Promise<string> {
  const answer = await access.fetch(api.cellFile(file));
  if (!answer.ok) throw new Error(`${file}: status ${answer.status}`);
  return answer.text();
}

export async function loadWorld(): Promise<World> {
  const { bodies, robots } = await api.cell();
  return { bodies, robots: await Promise.all(robots.map(async (robot) => ({ ...robot, text: await textOf(robot.urdf) }))) };
}

/** The world, or why there is none. */
export function useWorld(): { readonly world: World | undefined; readonly problem: string | undefined } {
  const away = useSession(cellUnavailable);
  const [world, setWorld] = useState<World>();
  const [refused, setRefused] = useState<string>();
  useEffect(() => {
    if (away !== undefined) return;
    const end = loadInAttempts(loadWorld, {
      onLoaded(loaded) {
        setWorld(loaded);
        setRefused(undefined);
      },
      onFailed: (error) => setRefused(messageOf(error)),
    });
    return () => {
      end();
      setWorld(undefined);
      setRefused(undefined);
    };
  }, [away]);
  return { world, problem: away ?? refused };
}
