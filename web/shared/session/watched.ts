// Which core the page shows, and its place in the address: `?run=ID`. A run keeps its id when the server is started again.
import type { Core } from "../../generated/messages";
import { isOver } from "../run/controls";
import { isInterrupted } from "../run/interruption";

/** The core that the address names. */
export function runOfAddress(search: string): string | undefined {
  return new URLSearchParams(search).get("run") ?? undefined;
}

/** The query of the address, with this core in it. */
export function addressOfRun(search: string, id: string): string {
  const query = new URLSearchParams(search);
  query.set("run", id);
  return `?${query.toString()}`;
}

/** The core that the page shows: the `wanted` one if it is there, else one that waits for a person after an interruption, else one that is not over; of these the newest. */
export function coreToWatch(cores: readonly Core[], wanted: string | undefined): Core | undefined {
  const newest = (holds: (core: Core) => boolean): Core | undefined => cores.filter(holds).at(-1);
  return newest(({ id }) => id === wanted) ?? newest(isInterrupted) ?? newest((core) => !isOver(core)) ?? cores.at(-1);
}
