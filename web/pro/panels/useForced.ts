// What was forced in the watched run: its journal is read once, and again where deltas were left out; what comes is in the deltas.
import { useEffect, useMemo, useState } from "react";
import { allForced, forcedInJournal, type Forced } from "../../shared/run/forced";
import { api, useSession } from "../client";

const kNone: readonly Forced[] = [];

export function useForced(): readonly Forced[] {
  const id = useSession((s) => s.watched);
  const since = useSession((s) => s.forced);
  const snapshots = useSession((s) => s.snapshots);
  const [past, setPast] = useState<{ readonly id: string; readonly forced: readonly Forced[] }>();
  useEffect(() => {
    if (id === undefined) return;
    let current = true;
    api.journal(id).then(
      (journal) => current && setPast({ id, forced: forcedInJournal(journal) }),
      () => undefined, // What is forced from now on is there.
    );
    return () => {
      current = false;
    };
  }, [id, snapshots]);
  const before = past?.id === id ? past?.forced : undefined;
  return useMemo(() => allForced(before ?? kNone, since), [before, since]);
}
