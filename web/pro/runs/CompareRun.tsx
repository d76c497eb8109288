// A stored run compared with the one that is shown: where they first did different things, and the way there in either.
import { useEffect, useState } from "react";
import type { RunComparison } from "../../generated/messages";
import { compareAll, comparisonText, firstDifference } from "../../shared/runs/compare";
import { api } from "../client";
import { useAttempt } from "../documents/useAttempt";
import { openRunAt } from "./actions";
import { messageOf } from "../../shared/messageOf";

interface Props {
  readonly id: string;
  /** The run that is shown. */
  readonly other: string;
}

type Answer = RunComparison | { readonly failed: string };

export function CompareRun({ id, other }: Props) {
  const [answer, setAnswer] = useState<Answer>();
  const { attempt, reason, busy } = useAttempt();
  useEffect(() => {
    let current = true;
    compareAll((from) => api.compareRuns(other, id, from)).then(
      (found) => current && setAnswer(found),
      (error: unknown) => current && setAnswer({ failed: messageOf(error) }),
    );
    return () => {
      current = false;
    };
  }, [id, other]);
  const moment = answer === undefined || "failed" in answer ? undefined : firstDifference(answer);
  return (
    <div className="compare-run" role="group" aria-label={`Run ${other} and run ${id}`}>
      <p role="status">{answer === undefined ? `Comparing run ${other} and run ${id}…` : "failed" in answer ? answer.failed : comparisonText(answer, [other, id])}</p>
      {moment !== undefined &&
        [other, id].map((each) => (
          <button key={each} type="button" disabled={busy} onClick={() => void attempt(() => openRunAt(each, moment))}>
            Show in run {each}
          </button>
        ))}
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </div>
  );
}
