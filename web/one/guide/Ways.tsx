// The ways from a step of the guide.
import type { GuideStep } from "../place";
import { texts } from "../texts";
import { goToStep, stepAt } from "./steps";

interface WaysProps {
  readonly step: GuideStep;
  /** Nothing keeps from going on. */
  readonly isReady: boolean;
}

/** Below a step: back and on. */
export function Ways({ step, isReady }: WaysProps) {
  const [back, next] = [stepAt(step, -1), stepAt(step, 1)];
  return (
    <div className="guided-ways">
      {back !== undefined && (
        <button type="button" onClick={() => goToStep(back, step)}>
          {texts.guide.back}
        </button>
      )}
      {next !== undefined && (
        <button type="button" className="main" disabled={!isReady} onClick={() => goToStep(next, step)}>
          {texts.guide.next}
        </button>
      )}
    </div>
  );
}
