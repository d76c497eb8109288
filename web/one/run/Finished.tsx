// How often the application has been done, and how long it took last.
import { useEffect, useState } from "react";
import type { Run } from "../../generated/messages";
import { isBadOutcome, isOver } from "../../shared/run/controls";
import { runTime } from "../../shared/runs/texts";
import { api, useCore } from "../client";
import { texts } from "../texts";

const t = texts.runView;

/** Of the runs that the server has stored, the last 100. */
export function Finished({ name }: { readonly name: string }) {
  const core = useCore();
  const over = core === undefined || isOver(core) ? (core?.id ?? "none") : "going";
  const [runs, setRuns] = useState<readonly Run[]>([]);
  useEffect(() => {
    let current = true;
    api.runs(name).then(
      (list) => current && setRuns(list.runs),
      // Without it the run can still be seen.
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [name, over]);
  const ended = runs.filter((run) => run.status === "ended" && !isBadOutcome(run.outcome));
  const failed = runs.filter((run) => run.status === "faulted" || (run.status === "ended" && isBadOutcome(run.outcome)));
  const [last] = ended;
  if (ended.length + failed.length === 0) return null;
  return (
    <dl className="finished" aria-label={t.untilNow}>
      <div>
        <dt>{t.doneCount}</dt>
        <dd>{ended.length}</dd>
      </div>
      <div>
        <dt>{t.failedCount}</dt>
        <dd>{failed.length}</dd>
      </div>
      {last !== undefined && (
        <div>
          <dt>{t.cycleTime}</dt>
          <dd>{runTime(last)}</dd>
        </div>
      )}
    </dl>
  );
}
