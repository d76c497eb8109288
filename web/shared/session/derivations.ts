// Whether the page needs the derivations of the watched run as they are made: up to a megabyte a second.
import { isStored, watchedCore, type Session } from "./session";
import type { View } from "./view";

/** The id of the run whose derivations are to be sent; nothing while it runs and nothing shown depends on them. */
export function derivationsWanted(session: Session, view: Pick<View, "drawer" | "selection" | "asked">): string | undefined {
  const core = watchedCore(session);
  if (core === undefined || isStored(session)) return undefined;
  const runs = core.status === "running" && !core.paused;
  const isShown = view.drawer === "derivation" || view.selection?.kind === "port" || view.asked !== undefined || session.past !== undefined;
  return !runs || isShown ? core.id : undefined;
}
