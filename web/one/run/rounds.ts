// In which round the loops of the watched run are, and how long rounds took while this page watched.
import { useEffect, useMemo, useState } from "react";
import { watchedCore } from "../../shared/session/session";
import { activeIds, type Progress } from "../../shared/timeline/progress";
import type { Application } from "../../shared/timeline/read";
import { doneIn, roundsIn, timed, type Round, type RoundTimes } from "../../shared/timeline/rounds";
import type { Step } from "../../shared/timeline/timeLine";
import { session, useSession } from "../client";
import { everyStep } from "../model";
import { treeOfRun } from "./failed";

export interface ShownRound extends Round {
  readonly times: RoundTimes | undefined;
}

/** Of the loops in which the run is, the outer ones first. */
export function useRounds(application: Application | undefined, progress: Progress): readonly ShownRound[] {
  const loops = useMemo(() => (application === undefined ? [] : everyStep(application).filter(({ counter }) => counter !== undefined)), [application]);
  const times = useTimes(loops);
  const run = useSession((s) => s.run);
  const model = useSession((s) => s.model);
  return useMemo(() => {
    const tree = treeOfRun({ model });
    if (tree === undefined || run === undefined) return [];
    return roundsIn(progress.now, tree, run, activeIds(run.active, tree)).map((round) => ({ ...round, times: times.get(round.loop.id) }));
  }, [progress, run, model, times]);
}

interface Watch {
  readonly run: string | undefined;
  /** Whole states that have come: what was before is not seen. */
  readonly snapshots: number;
  readonly times: ReadonlyMap<string, RoundTimes>;
}

function useTimes(loops: readonly Step[]): ReadonlyMap<string, RoundTimes> {
  const [watch, setWatch] = useState<Watch>({ run: undefined, snapshots: 0, times: new Map() });
  useEffect(() => {
    const look = () => {
      const now = performance.now();
      const seen = session.get();
      const [tree, core, run] = [treeOfRun(seen), watchedCore(seen), seen.run];
      if (tree === undefined || core === undefined || run === undefined) return;
      const active = activeIds(run.active, tree);
      setWatch((before) => {
        const isSame = before.run === core.id;
        const isHeld = core.status !== "running" || core.paused || before.snapshots !== seen.snapshots;
        const times = loops.map((loop): readonly [string, RoundTimes] => {
          const known = isSame ? before.times.get(loop.id) : undefined;
          // A run that is over has done its last round.
          return [loop.id, timed(known, { isActive: active.has(loop.id), done: doneIn(loop, tree, run) ?? 0, isHeld: isHeld && core.status !== "ended", now })];
        });
        const isNews = !isSame || before.snapshots !== seen.snapshots || times.some(([id, each]) => before.times.get(id) !== each);
        return isNews ? { run: core.id, snapshots: seen.snapshots, times: new Map(times) } : before;
      });
    };
    return session.listen(look);
  }, [loops]);
  return watch.times;
}
