// What cannot be done while the cell is stopped: what lets a run begin or go on.
import { doingOfAction, doingOfCommand, type Doing } from "../login/doings";
import type { Command } from "../run/controls";
import { isStopped, type StopState } from "./state";

type Known = Pick<StopState, "stopped">;

const kStarting: ReadonlySet<Doing> = new Set(["start_run", "resume_run", "step_run"]);

/** Why nothing begins now; nothing: it may. */
export const refusalToBegin = (stop: Known): string | undefined => (isStopped(stop) ? "the cell is stopped" : undefined);

export const refusalOfDoing = (stop: Known, doing: Doing): string | undefined => (kStarting.has(doing) ? refusalToBegin(stop) : undefined);

/** To run again is to start a new run. */
export const refusalOfCommand = (stop: Known, command: Command): string | undefined => (command === "again" ? refusalToBegin(stop) : refusalOfDoing(stop, doingOfCommand[command]));

/** Of an action of the editor or the debugger. */
export function refusalOfActionByStop(stop: Known, action: { readonly id: string; readonly group: string }): string | undefined {
  const doing = doingOfAction(action);
  return doing && refusalOfDoing(stop, doing);
}
