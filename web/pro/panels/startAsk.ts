// Whatever starts a run that moves the robot, key or button, does so only once a person has said so: of each document once in a tab of the
// browser, unless they want to be asked each time.
import type { Core } from "../../generated/messages";
import type { ExactArguments } from "../../shared/api";
import { movedBy } from "../../shared/run/moving";
import { allowed, setsGoing, type Command, type UntilRequest } from "../../shared/run/controls";
import { commandable, watchedCore, type Session } from "../../shared/session/session";
import { api, problem, session } from "../client";
import { refusalOfCommandNow } from "../login/rights";
import { makeRun, run } from "../runCommands";
import { createStore, useSelected } from "../../page/store";

export interface StartAsk {
  readonly command: Command;
  /** How far, if it is a step until something is reached. */
  readonly until?: UntilRequest;
  /** The run that was watched then, its document, and its status. */
  readonly core: Pick<Core, "id" | "document" | "status">;
}

const store = createStore<StartAsk | undefined, StartAsk | undefined>(undefined, (_, asked) => asked);
export const useStartAsk = (): StartAsk | undefined => useSelected(store, (asked) => asked);

const keyOf = (document: string): string => `race.moves.${document}`;

/** Without storage, it is asked each time. */
function isAllowed(document: string): boolean {
  try {
    return sessionStorage.getItem(keyOf(document)) !== null;
  } catch {
    return false;
  }
}

function allow(document: string): void {
  try {
    sessionStorage.setItem(keyOf(document), "1");
  } catch {
    // It is asked again.
  }
}

/** Carries a command out on the watched core: one that sets a task going only once a person has said that what moves may move. */
export function command(wanted: Command, until?: UntilRequest): void {
  const now = session.get();
  const core = watchedCore(now);
  if (core === undefined) return;
  const refusal = refusalOfCommandNow(wanted);
  if (refusal !== undefined) {
    problem(`Not done: ${refusal}.`);
    return;
  }
  if (!setsGoing(wanted, core) || movedBy(now.model, now.services)?.length === 0 || isAllowed(core.document)) void run(wanted, until);
  else if (store.get() === undefined) store.dispatch({ command: wanted, core, ...(until !== undefined && { until }) });
}

/** Makes a run and starts it, by the same rule: `made` is called before it is asked. Throws what the server refuses. */
export async function makeStarted(document: string, args: ExactArguments, made?: () => void): Promise<void> {
  const atOnce = isAllowed(document) || movedBy(await api.documentModel(document), session.get().services)?.length === 0;
  const core = await makeRun(document, atOnce, args);
  made?.();
  if (!atOnce) store.dispatch({ command: "start", core });
}

/** Whether what is asked about can still be done: not if another run is shown, or this one has gone on meanwhile. */
export function stillHolds(now: Session, { core, command }: StartAsk): boolean {
  const shown = commandable(now);
  return shown?.id === core.id && shown.status === core.status && allowed(shown).has(command);
}

/** `remember`: this document is not asked for again in this tab. */
export function answerStart({ command, until, core }: StartAsk, starts: boolean, remember: boolean): void {
  store.dispatch(undefined);
  if (!starts) return;
  if (remember) allow(core.document);
  void run(command, until);
}
