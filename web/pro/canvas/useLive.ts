// The live state of the run for nodes and lines: each selects the part that it shows, so a step redraws only what it changed.
import { liveOf, kNoRun, type Live } from "../../shared/drawing/live";
import { emptySession, watchedCore, type Session } from "../../shared/session/session";
import { useSession, view } from "../client";

let latest: { readonly session: Session; readonly live: Live } = { session: emptySession, live: kNoRun };

/** Computed once per change of the session, for all nodes. A document that is edited does not run. */
function liveFor(session: Session): Live {
  if (view.get().page === "edit") return kNoRun;
  if (latest.session !== session) latest = { session, live: liveOf(session.run, session.fired, watchedCore(session)?.fault) };
  return latest.live;
}

/** What `select` reads of the run; it must give the same value while nothing that it shows has changed. */
export const useLive = <T>(select: (live: Live) => T): T => useSession((session) => select(liveFor(session)));
