// Whether the cell can be put back to how it was at the start: not under a run that has begun.
import type { Core } from "../../generated/messages";
import { isOver } from "../run/controls";

/** Why it cannot be reset now, as the server would say; nothing: it can. */
export function refusalToReset(cores: readonly Core[]): string | undefined {
  const open = cores.find((core) => core.status !== "ready" && !isOver(core));
  return open === undefined ? undefined : `run ${open.id} of ${open.document} is not over; stop it before the cell is reset`;
}
