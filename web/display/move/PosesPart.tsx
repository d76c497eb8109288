// Taught poses: the arm goes to one while its button is held; one is replaced or removed after a second tap.
import { useState } from "react";
import { GoToPose } from "../../control/GoToPose";
import { SavePose } from "../../control/SavePose";
import type { TaughtPose } from "../../shared/pendant/poses";
import { useRefusal } from "../client";
import { hand } from "./hand";

export function PosesPart({ refusal }: { readonly refusal: string | undefined }) {
  const saved = hand.usePoses((now) => now.poses);
  const problem = hand.usePoses((now) => now.problem);
  const isLoaded = hand.usePoses((now) => now.isLoaded);
  return (
    <div className="poses">
      <SavePose hand={hand} isNamed />
      {problem !== undefined && (
        <p className="is-bad" role="alert">
          The poses cannot be read: {problem}.{" "}
          <button type="button" className="plain" onClick={hand.poses.load}>
            Try again
          </button>
        </p>
      )}
      {isLoaded && saved.length === 0 && <p className="empty">No pose is saved yet. Move the arm to a place that matters, then save it here; tasks use it by its name.</p>}
      <ul aria-label="Saved poses">
        {saved.map((pose) => (
          <PoseRow key={pose.name} pose={pose} refusal={refusal} />
        ))}
      </ul>
    </div>
  );
}

function PoseRow({ pose, refusal }: { readonly pose: TaughtPose; readonly refusal: string | undefined }) {
  const [asks, setAsks] = useState(false);
  const [problem, setProblem] = useState<string>();
  const cannot = useRefusal("call_service");
  return (
    <li>
      <div className="pose-row">
        <b>{pose.name}</b>
        <GoToPose hand={hand} pose={pose} refusal={refusal} />
        <button type="button" className="plain is-small" aria-label={`Remove ${pose.name}`} aria-expanded={asks} disabled={cannot !== undefined} title={cannot} onClick={() => setAsks(!asks)}>
          ✕
        </button>
      </div>
      {asks && (
        <p className="pose-ask">
          <span>Tasks that use it will not find it.</span>
          <button type="button" className="plain" onClick={() => void hand.poses.remove(pose.name).then(setProblem)}>
            Remove {pose.name}
          </button>
        </p>
      )}
      {problem !== undefined && <p className="is-bad" role="alert">Not removed: {problem}.</p>}
    </li>
  );
}
