// Why the account that uses a page may not do something, or why it cannot be done now: while the cell is stopped, or without the controls.
import { refusalTo, doingOfCommand, type Doing } from "../shared/login/doings";
import type { Access } from "../shared/login/access";
import type { Command } from "../shared/run/controls";
import type { Told } from "../shared/slowly";
import { refusalOfCommand, refusalOfDoing, refusalToBegin } from "../shared/stop/refusals";
import { stop } from "../stop/page";
import { useStop } from "../stop/useStop";
import { useSelected } from "./store";

export interface Rights {
  readonly refusalNow: (doing: Doing) => string | undefined;
  readonly useRefusal: (doing: Doing) => string | undefined;
  /** Of a command of a run. */
  readonly refusalOfCommandNow: (command: Command) => string | undefined;
  readonly useRefusalOfCommand: (command: Command) => string | undefined;
  /** Of what makes a run and starts it. */
  readonly useRefusalToStart: () => string | undefined;
}

/** `login`: who uses the page. */
export function createRights(login: Told<Access>): Rights {
  const useOfAccount = (doing: Doing): string | undefined => useSelected(login, ({ me }) => refusalTo(me, doing));
  function useRefusal(doing: Doing): string | undefined {
    const ofAccount = useOfAccount(doing);
    const ofStop = useStop((now) => refusalOfDoing(now, doing));
    return ofAccount ?? ofStop;
  }
  function useRefusalOfCommand(command: Command): string | undefined {
    const ofAccount = useOfAccount(doingOfCommand[command]);
    const ofStop = useStop((now) => refusalOfCommand(now, command));
    return ofAccount ?? ofStop;
  }
  function useRefusalToStart(): string | undefined {
    const refusal = useRefusal("make_run");
    const ofStop = useStop(refusalToBegin);
    return refusal ?? ofStop;
  }
  return {
    refusalNow: (doing) => refusalTo(login.get().me, doing) ?? refusalOfDoing(stop.get(), doing),
    useRefusal,
    refusalOfCommandNow: (command) => refusalTo(login.get().me, doingOfCommand[command]) ?? refusalOfCommand(stop.get(), command),
    useRefusalOfCommand,
    useRefusalToStart,
  };
}
