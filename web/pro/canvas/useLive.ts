// The live state of the run for nodes and lines: each selects the part that it shows, so a step redraws only what it changed. On the page that
// edits it is that of a run of the document, in the addresses of the edited model.
import { kNoRun, liveOf, type Live } from "../../shared/drawing/live";
import { projectLive } from "../../shared/live/project";
import { badEndShown, faultShown, firedShown, stateShown } from "../../shared/past/shown";
import { watchedCore } from "../../shared/session/session";
import { session, view } from "../client";
import { editedTree, editing } from "../edit/editing";
import { shownRun } from "../live/shownRun";
import { createStore, slowly, useSelected } from "../../page/store";

const store = createStore<Live, Live>(kNoRun, (_, live) => live);

/** What the live state was made of last: it is the same until one of these is another. */
let made: readonly unknown[] = [];

function refresh(): void {
  const now = session.get();
  const isEdited = view.get().page === "edit";
  const shown = isEdited ? shownRun(now) : undefined;
  const onto = shown && editedTree();
  const [run, fired, fault, badEnd] = [stateShown(now), firedShown(now), faultShown(now), badEndShown(now)];
  const of = isEdited && (shown === undefined || onto === undefined) ? [] : [run, fired, fault, badEnd, shown?.tree, onto];
  if (of.length === made.length && of.every((each, i) => each === made[i])) return;
  made = of;
  const live = of.length === 0 ? kNoRun : liveOf(run, fired, { fault, badEnd });
  store.dispatch(shown === undefined || onto === undefined ? live : projectLive(live, shown.tree, onto));
}
session.listen(refresh);
view.listen(refresh);
editing.listen(refresh);

/** What `select` reads of the run; it must give the same value while nothing that it shows has changed. */
export const useLive = <T>(select: (live: Live) => T): T => useSelected(store, select);

/** Whether the run goes on by itself as one looks at it; at a moment of the past, and while it is paused, each step is one that a person wants to see. */
function goesOn(): boolean {
  const now = session.get();
  const core = watchedCore(now);
  return now.past === undefined && core?.status === "running" && !core.paused;
}

const shownSlowly = slowly(store, (before, now) => !goesOn() || before.faultAt !== now.faultAt || (before.run === undefined) !== (now.run === undefined));
/** As `useLive`, for what is beside the drawing or not seen: of a run that goes on, late by a tenth of a second at most. */
export const useLiveSlowly = <T>(select: (live: Live) => T): T => useSelected(shownSlowly, select);

/** The live state now, for what is painted. */
export const liveNow = (): Live => store.get();

/** Calls `listener` when the live state has changed; the result ends that. */
export const listenToLive = (listener: () => void): (() => void) => store.listen(listener);
