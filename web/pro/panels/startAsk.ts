// A key starts a run that moves the robot only once a person has said so: of each document once in a tab of the browser, unless they want to
// be asked each time. The button Start does not ask: it is pointed at, and says what it does.
import { movedBy } from "../../shared/run/moving";
import type { Command } from "../../shared/run/controls";
import { watchedCore } from "../../shared/session/session";
import { run, session } from "../client";
import { createStore, useSelected } from "../store";

export interface StartAsk {
  readonly command: Command;
  /** The run that was watched then, and its document. */
  readonly id: string;
  readonly document: string;
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

/** Starts, resumes or runs again, once a person has said that what moves may move. */
export function leadByKey(command: Command): void {
  const now = session.get();
  const core = watchedCore(now);
  if (core === undefined || store.get() !== undefined) return;
  if (movedBy(now.model, now.services)?.length === 0 || isAllowed(core.document)) void run(command);
  else store.dispatch({ command, id: core.id, document: core.document });
}

/** `remember`: this document is not asked for again in this tab. */
export function answerStart({ command, document }: StartAsk, starts: boolean, remember: boolean): void {
  store.dispatch(undefined);
  if (!starts) return;
  if (remember) allow(document);
  void run(command);
}
