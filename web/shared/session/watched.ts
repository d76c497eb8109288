// Which core the page shows. A run keeps its id when the server is started again.
import type { Core } from "../../generated/messages";
import { isOver } from "../run/controls";
import { isInterrupted } from "../run/interruption";

/** The core that the page shows: the `wanted` one if it is there, else one that waits for a person after an interruption, else one that is not over; of these the newest. */
export function coreToWatch(cores: readonly Core[], wanted: string | undefined): Core | undefined {
  const newest = (holds: (core: Core) => boolean): Core | undefined => cores.filter(holds).at(-1);
  return newest(({ id }) => id === wanted) ?? newest(isInterrupted) ?? newest((core) => !isOver(core)) ?? cores.at(-1);
}
