// The run that is shown on the drawing of the document that is edited: the watched one, if it is of this document and the user has not hidden it.
import type { Core } from "../../generated/messages";
import { runOfDocument } from "../../shared/live/shownRun";
import type { ModelTree } from "../../shared/model/modelTree";
import { stateShown } from "../../shared/past/shown";
import type { LiveState } from "../../shared/run/liveState";
import { watchedCore, type Session } from "../../shared/session/session";
import { session, useSession, useView, view } from "../client";
import { editing, useEditing } from "../edit/editing";
import { runTree } from "./runTree";

/** The watched run, if it is of the document that is edited. */
export function useRunOfDocument(): Core | undefined {
  const document = useEditing((now) => now.document);
  return useSession((now) => runOfDocument(watchedCore(now), document));
}

/** What a form shows of a run. */
export interface ShownRun {
  readonly core: Core;
  readonly run: LiveState;
  readonly tree: ModelTree;
}

/** Nothing: none is shown, or its state is not here yet. */
export function shownRun(now: Session = session.get()): ShownRun | undefined {
  const core = runOfDocument(watchedCore(now), editing.get().document);
  const tree = runTree();
  const run = stateShown(now);
  const { page, runShown } = view.get();
  if (page !== "edit" || !runShown || core === undefined || run === undefined || tree === undefined) return undefined;
  return { core, run, tree };
}

/** What `select` reads of the run that is shown; it must give the same value while nothing that it shows has changed. */
export function useShownRun<T>(select: (shown: ShownRun) => T): T | undefined {
  // Whether it is shown depends on these, too.
  useView(({ page, runShown }) => page === "edit" && runShown);
  useEditing(({ document }) => document);
  return useSession((now) => {
    const shown = shownRun(now);
    return shown && select(shown);
  });
}
