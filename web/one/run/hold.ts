// A run is held while a person moves what it moves, and goes on afterwards.
import type { CellMode, Core } from "../../generated/messages";
import { setMode } from "../../shared/control/requests";
import { isOwn } from "../../shared/control/texts";
import { allowed, isOver } from "../../shared/run/controls";
import { stop } from "../../stop/page";
import { api, fetcher } from "../client";

async function turnTo(mode: CellMode): Promise<void> {
  if (stop.get().mode !== mode) stop.take(await setMode(fetcher, mode));
}

/**
 * Pauses the run. What it has reserved makes way for a hand after a change of the mode (server/control): in execution mode one comes before the
 * robot is moved by hand; in programming mode it would not, so the mode changes here, to and fro.
 */
export async function holdForHand(core: Core): Promise<void> {
  if (allowed(core).has("pause")) await api.pause(core.id);
  const { mode, leases, holder, held } = stop.get();
  if (mode !== "programming" || !isOwn(holder, held) || !leases.some((lease) => lease.core === core.id)) return;
  await turnTo("execution");
  await turnTo("programming");
}

/** The mode of the cell before a pose was taught, and the run for which that was. */
export interface ModeBefore {
  readonly run: string;
  readonly mode: CellMode | undefined;
}

/** While the run waits, or after its end, teaching may begin more than once. */
export const modeBefore = (core: Core, before: ModeBefore | undefined): ModeBefore =>
  before?.run === core.id && (core.paused || isOver(core)) ? before : { run: core.id, mode: stop.get().mode };

/** In the mode of before. */
export async function goOnIn(mode: CellMode | undefined, goOn: () => Promise<unknown>): Promise<void> {
  if (mode !== undefined) await turnTo(mode);
  await goOn();
}
