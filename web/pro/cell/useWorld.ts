// What the cell looks like: asked for when its world is there, and again when it has come back, as it may be another one.
import { useEffect, useState } from "react";
import type { Body } from "../../generated/messages";
import { cellAway } from "../../shared/session/session";
import { api, useSession } from "../client";
import type { RobotModel } from "./CellScene";

export interface World {
  readonly bodies: readonly Body[];
  readonly robots: readonly RobotModel[];
}

async function textOf(file: string): Promise<string> {
  const answer = await fetch(api.cellFile(file));
  if (!answer.ok) throw new Error(`${file}: status ${answer.status}`);
  return answer.text();
}

async function load(): Promise<World> {
  const { bodies, robots } = await api.cell();
  return { bodies, robots: await Promise.all(robots.map(async (robot) => ({ ...robot, text: await textOf(robot.urdf) }))) };
}

/** The world; without one, why there is none, as soon as that is known. */
export function useWorld(): { readonly world: World | undefined; readonly problem: string | undefined } {
  const away = useSession(cellAway);
  const [world, setWorld] = useState<World>();
  const [refused, setRefused] = useState<string>();
  useEffect(() => {
    if (away !== undefined) return;
    let current = true;
    load().then(
      (loaded) => current && setWorld(loaded),
      (error: unknown) => current && setRefused(error instanceof Error ? error.message : String(error)),
    );
    return () => {
      current = false;
      setWorld(undefined);
      setRefused(undefined);
    };
  }, [away]);
  return { world, problem: away ?? refused };
}
