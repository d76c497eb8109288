// How often the application has been done, of which runs, and how long it took.
import { useEffect, useState } from "react";
import type { Run } from "../../generated/messages";
import { isOver } from "../../shared/run/controls";
import { outcomesOf } from "../../shared/runs/outcomes";
import { durationText } from "../../shared/runs/texts";
import { api, useCore } from "../client";
import { texts } from "../texts";

const t = texts.runView;

/** Of the runs that the server has stored, the newest: it lists so many at once, and says whether there are older ones. */
export function Finished({ name }: { readonly name: string }) {
  const core = useCore();
  const over = core === undefined || isOver(core) ? (core?.id ?? "none") : "going";
  const [listed, setListed] = useState<{ readonly runs: readonly Run[]; readonly areMore: boolean }>({ runs: [], areMore: false });
  useEffect(() => {
    let current = true;
    api.runs(name).then(
      ({ runs, next }) => current && setListed({ runs, areMore: next !== undefined }),
      // Without it the run can still be seen.
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [name, over]);
  const { over: count, finished, failed, stopped, last, mean } = outcomesOf(listed.runs);
  if (count === 0) return null;
  return (
    <section className="finished" aria-label={t.untilNow}>
      <p>{t.outcomes(listed.areMore ? t.ofLast(count) : t.ofAll(count), finished, failed, stopped)}</p>
      {last !== undefined && mean !== undefined && (
        <dl>
          <div>
            <dt>{t.cycleTime}</dt>
            <dd>{durationText(last)}</dd>
          </div>
          {finished > 1 && (
            <div>
              <dt>{t.meanTime(finished)}</dt>
              <dd>{durationText(mean)}</dd>
            </div>
          )}
        </dl>
      )}
    </section>
  );
}
