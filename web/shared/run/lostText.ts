// What the page says while its server does not answer.
import type { Core } from "../../generated/messages";
import { isOver, statusText } from "./controls";

export interface LostText {
  readonly title: string;
  readonly holds: string;
}

/** Of a run that may still move the robot, that STOP does not reach it. `core`: the watched one, as it was last heard of; `ended`: the server has ended, as it said. */
export function lostText(core: Core | undefined, ended = false): LostText {
  const shown = "What is shown is what was last heard. The page tries to connect again.";
  if (core === undefined || core.status === "ready" || isOver(core)) return { title: ended ? "The server has ended" : "Server lost", holds: shown };
  if (ended) return { title: `The server has ended; run ${core.id} was at step ${core.step}`, holds: `It has told the services to stop what moves. When it starts again, the run waits until a person resumes it. ${shown}` };
  const micro = core.micro > 0 ? `, micro step ${core.micro}` : "";
  return { title: `Server lost at step ${core.step}${micro} of run ${core.id}: pause and stop cannot reach the robot`, holds: `Stop the robot at the robot itself, if it must stop. ${shown}` };
}

/** The status of a run that may have gone on since it was last heard of. */
export const lastStatusText = (core: Core): string => (isOver(core) ? statusText(core) : `Not known; last: ${statusText(core)}`);
