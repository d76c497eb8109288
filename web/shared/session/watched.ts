// Which core the page shows. A run keeps its id when the server is started again.
import type { Core } from "../../generated/messages";
import { isOver } from "../run/controls";
import { isInterrupted } from "../run/interruption";

/**
 * The core that the page shows: the `wanted` one if it is there, else one that waits for a person after an interruption, else one that is not over;
 * of these one of the document that is `edited`, if there is any, and the newest.
 */
export function coreToWatch(cores: readonly Core[], wanted: string | undefined, edited?: string): Core | undefined {
  const newest = (holds: (core: Core) => boolean): Core | undefined => cores.filter((core) => holds(core) && core.document === edited).at(-1) ?? cores.filter(holds).at(-1);
  return newest(({ id }) => id === wanted) ?? newest(isInterrupted) ?? newest((core) => !isOver(core)) ?? newest(() => true);
}
