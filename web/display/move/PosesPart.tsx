// Taught poses: the arm goes to one while its button is held; one is replaced or removed after a second tap.
import { useState } from "react";
import { GoToPose } from "../../control/GoToPose";
import { SavePose } from "../../control/SavePose";
import type { TaughtPose } from "../../shared/pendant/poses";
import { useRefusal } from "../client";
import { texts } from "../texts";
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
          {texts.poses.unreadable(problem)}{" "}
          <button type="button" className="plain" onClick={hand.poses.load}>
            {texts.poses.tryAgain}
          </button>
        </p>
      )}
      {isLoaded && saved.length === 0 && <p className="empty">{texts.poses.none}</p>}
      <ul aria-label={texts.poses.saved}>
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
        <button type="button" className="plain is-small" aria-label={texts.poses.remove(pose.name)} aria-expanded={asks} disabled={cannot !== undefined} title={cannot} onClick={() => setAsks(!asks)}>
          ✕
        </button>
      </div>
      {asks && (
        <p className="pose-ask">
          <span>{texts.poses.removing}</span>
          <button type="button" className="plain" onClick={() => void hand.poses.remove(pose.name).then(setProblem)}>
            {texts.poses.remove(pose.name)}
          </button>
        </p>
      )}
      {problem !== undefined && <p className="is-bad" role="alert">{texts.poses.notRemoved(problem)}</p>}
    </li>
  );
}
