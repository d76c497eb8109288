// What cannot be done now: while the cell is stopped, while somebody else has the controls, or without them where they are needed.
import { isOwn } from "../control/texts";
import { doingOfAction, doingOfCommand, type Doing } from "../login/doings";
import type { Command } from "../run/controls";
import { isStopped, type StopState } from "./state";

type Known = Pick<StopState, "stopped" | "mode" | "holder" | "held">;

const kStarting: ReadonlySet<Doing> = new Set(["start_run", "resume_run", "step_run", "force"]);
const kOfHolder: ReadonlySet<Doing> = new Set(["set_mode", "set_speed", "confirm_edit", "move_by_hand"]);

const refusalWithout = (stop: Known): string | undefined =>
  isOwn(stop.holder, stop.held) ? undefined : stop.holder === null ? "take the controls first" : `${stop.holder.by} has the controls`;

/** Why nothing begins now; nothing: it may. */
export function refusalToBegin(stop: Known): string | undefined {
  if (isStopped(stop)) return "the cell is stopped";
  if (stop.holder === null && stop.mode !== "programming") return undefined;
  const refusal = refusalWithout(stop);
  return refusal !== undefined && stop.holder === null ? `in programming mode, ${refusal}` : refusal;
}

/** Why nothing is moved by hand now. */
export function refusalToMove(stop: Known): string | undefined {
  if (isStopped(stop)) return "the cell is stopped";
  return refusalWithout(stop) ?? (stop.mode === "programming" ? undefined : "this needs programming mode");
}

/** Why the arm is not put where it was at the start. */
function refusalToReset(stop: Known): string | undefined {
  if (isStopped(stop)) return "the cell is stopped";
  return stop.holder === null ? undefined : refusalWithout(stop);
}

export function refusalOfDoing(stop: Known, doing: Doing): string | undefined {
  if (kStarting.has(doing)) return refusalToBegin(stop);
  if (doing === "move_by_hand") return refusalToMove(stop);
  if (doing === "reset_cell") return refusalToReset(stop);
  return kOfHolder.has(doing) ? refusalWithout(stop) : undefined;
}

/** To run again is to start a new run. */
export const refusalOfCommand = (stop: Known, command: Command): string | undefined => (command === "again" ? refusalToBegin(stop) : refusalOfDoing(stop, doingOfCommand[command]));

/** Of an action of the editor or the debugger. */
export function refusalOfActionByStop(stop: Known, action: { readonly id: string; readonly group: string }): string | undefined {
  const doing = doingOfAction(action);
  return doing && refusalOfDoing(stop, doing);
}
