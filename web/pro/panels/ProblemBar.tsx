// The latest error, over the run bar, where it covers nothing; until the user dismisses it.
import { dismissProblem, useSession } from "../client";

export function ProblemBar() {
  const problem = useSession((s) => s.problem);
  if (problem === undefined) return null;
  return (
    <div className="problem" role="alert">
      <span>{problem}</span>
      <button type="button" aria-label="Dismiss" onClick={dismissProblem}>
        ✕
      </button>
    </div>
  );
}
