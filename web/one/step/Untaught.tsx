// A pose that nobody has taught, with the way there.
import type { Untaught } from "../../shared/timeline/problems";
import { texts } from "../texts";
import { goToTeach } from "./atPose";

const t = texts.pose;

export function UntaughtPose({ untaught }: { readonly untaught: Untaught }) {
  return (
    <p className="untaught">
      <span>{t.untaught(untaught.pose)}</span>{" "}
      <button type="button" className="link" aria-label={t.teachItNamed(untaught.pose)} onClick={() => goToTeach(untaught)}>
        {t.teachIt}
      </button>
    </p>
  );
}
