// Why the account that uses the page may not do something, or why it cannot be done while the cell is stopped: for functions and for components.
import { refusalOfAction, refusalTo, doingOfCommand, type Doing } from "../../shared/login/doings";
import type { Command } from "../../shared/run/controls";
import { refusalOfActionByStop, refusalOfCommand, refusalOfDoing, refusalToBegin } from "../../shared/stop/refusals";
import { stop } from "../../stop/page";
import { useStop } from "../../stop/useStop";
import { login, useLogin } from "../client";

export const refusalNow = (doing: Doing): string | undefined => refusalTo(login.get().me, doing) ?? refusalOfDoing(stop.get(), doing);

export function useRefusal(doing: Doing): string | undefined {
  const ofAccount = useLogin(({ me }) => refusalTo(me, doing));
  const ofStop = useStop((now) => refusalOfDoing(now, doing));
  return ofAccount ?? ofStop;
}

/** Of a command of the watched run. */
export const refusalOfCommandNow = (command: Command): string | undefined => refusalTo(login.get().me, doingOfCommand[command]) ?? refusalOfCommand(stop.get(), command);

export function useRefusalOfCommand(command: Command): string | undefined {
  const ofAccount = useLogin(({ me }) => refusalTo(me, doingOfCommand[command]));
  const ofStop = useStop((now) => refusalOfCommand(now, command));
  return ofAccount ?? ofStop;
}

export const refusalOfActionNow = (action: { readonly id: string; readonly group: string }): string | undefined => refusalOfAction(login.get().me, action) ?? refusalOfActionByStop(stop.get(), action);

/** Of what makes a run and starts it. */
export function useRefusalToStart(): string | undefined {
  const ofAccount = useRefusal("make_run");
  const ofStop = useStop(refusalToBegin);
  return ofAccount ?? ofStop;
}
