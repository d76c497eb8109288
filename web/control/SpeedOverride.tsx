// How fast the robot goes on its way, whatever was asked for.
import { useRef, useState } from "react";
import type { RobotSpeed } from "../page/pageStream";
import { useSelected } from "../page/store";
import { messageOf } from "../shared/messageOf";
import { controls } from "./page";
import { texts } from "./texts";

/** Between two calls while the slider is moved [ms]; the last one comes in any case. */
const kPace = 150;
const kSteps = { least: 0, most: 1, step: 0.05 } as const;

interface Props {
  readonly speed: RobotSpeed;
  /** Why this person does not set it. */
  readonly refusal: string | undefined;
}

export function SpeedOverride({ speed, refusal }: Props) {
  const { robot, share: known } = useSelected(speed.store, (now) => now);
  /** Until the robot has it. */
  const [wanted, setWanted] = useState<number>();
  const [problem, setProblem] = useState<string>();
  const pace = useRef<{ readonly timer: ReturnType<typeof setTimeout>; waiting?: number }>(undefined);
  if (robot === undefined) return null;
  const share = wanted ?? known;
  const call = (next: number) => {
    const timer = setTimeout(() => {
      const { waiting } = pace.current ?? {};
      pace.current = undefined;
      if (waiting !== undefined) call(waiting);
    }, kPace);
    pace.current = { timer };
    controls.call(robot, "speed_override", { share: next }).then(
      () => {
        setProblem(undefined);
        setWanted((now) => (now === next ? undefined : now));
        speed.told(next);
      },
      (error: unknown) => {
        setProblem(messageOf(error));
        setWanted(undefined);
      },
    );
  };
  const change = (next: number) => {
    setWanted(next);
    if (pace.current === undefined) call(next);
    else pace.current.waiting = next;
  };
  const text = share === undefined ? texts.speed.unknown : share === 0 ? texts.speed.waits : texts.speed.share(Math.round(share * 100));
  return (
    <section className="speed-override" aria-label={texts.speed.name}>
      <label className="slider">
        <span>{texts.speed.label}</span>
        <input type="range" min={kSteps.least} max={kSteps.most} step={kSteps.step} value={share ?? 1} disabled={refusal !== undefined} aria-valuetext={text} onChange={(event) => change(Number(event.target.value))} />
        <output>{text}</output>
      </label>
      {refusal !== undefined && <p className="soft">{texts.speed.refused(refusal)}</p>}
      {problem !== undefined && <p className="is-bad" role="alert">{texts.speed.failed(problem)}</p>}
    </section>
  );
}
