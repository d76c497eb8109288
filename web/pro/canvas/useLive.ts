// The live state of the run for nodes and lines: each selects the part that it shows, so a step redraws only what it changed.
import { liveOf, kNoRun, type Live } from "../../shared/drawing/live";
import { emptySession, watchedCore, type Session } from "../../shared/session/session";
import { session, useSession, view } from "../client";

let latest: { readonly session: Session; readonly live: Live } = { session: emptySession, live: kNoRun };

/** Computed once per change of the session, for all nodes. A document that is edited does not run. */
function liveFor(now: Session): Live {
  if (view.get().page === "edit") return kNoRun;
  if (latest.session !== now) latest = { session: now, live: liveOf(now.run, now.fired, watchedCore(now)?.fault) };
  return latest.live;
}

/** What `select` reads of the run; it must give the same value while nothing that it shows has changed. */
export const useLive = <T>(select: (live: Live) => T): T => useSession((now) => select(liveFor(now)));

/** The live state now, for what is painted. */
export const liveNow = (): Live => liveFor(session.get());
