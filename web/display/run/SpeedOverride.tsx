// How fast the robot goes on its way, whatever was asked for.
import { useEffect, useRef, useState } from "react";
import { controls } from "../../control/page";
import { messageOf } from "../../shared/messageOf";
import { overridable } from "../../shared/control/jog";
import { isObject } from "../../shared/json";
import { api, useRefusal, useSession } from "../client";

/** Between two calls while the slider is moved [ms]; the last one comes in any case. */
const kPace = 150;
const kSteps = { least: 0, most: 1, step: 0.05 } as const;

export function SpeedOverride() {
  const robot = useSession((now) => overridable(now.services));
  const refusal = useRefusal("set_speed");
  const [share, setShare] = useState<number>();
  const [problem, setProblem] = useState<string>();
  const pace = useRef<{ readonly timer: ReturnType<typeof setTimeout>; waiting?: number }>(undefined);
  const isThere = useSession((now) => now.connection === "open");
  useEffect(() => {
    if (robot === undefined || !isThere) return;
    api.callService(robot, "state", {}).then(
      (state) => {
        const set = isObject(state) ? state["speed_override"] : undefined;
        if (typeof set === "number") setShare(set);
      },
      () => undefined, // it is not known, then
    );
  }, [robot, isThere]);
  if (robot === undefined) return null;
  const call = (next: number) => {
    const timer = setTimeout(() => {
      const { waiting } = pace.current ?? {};
      pace.current = undefined;
      if (waiting !== undefined) call(waiting);
    }, kPace);
    pace.current = { timer };
    controls.call(robot, "speed_override", { share: next }).then(
      () => setProblem(undefined),
      (error: unknown) => {
        setProblem(messageOf(error));
        setShare(undefined);
      },
    );
  };
  const change = (next: number) => {
    setShare(next);
    if (pace.current === undefined) call(next);
    else pace.current.waiting = next;
  };
  const text = share === undefined ? "not known" : share === 0 ? "it waits on its way" : `${Math.round(share * 100)} %`;
  return (
    <section aria-label="Speed of the robot">
      <label className="slider">
        <span>Robot speed</span>
        <input type="range" min={kSteps.least} max={kSteps.most} step={kSteps.step} value={share ?? 1} disabled={refusal !== undefined} aria-valuetext={text} onChange={(event) => change(Number(event.target.value))} />
        <output>{text}</output>
      </label>
      {refusal !== undefined && <p className="soft">To change it: {refusal}.</p>}
      {problem !== undefined && <p className="is-bad" role="alert">Not changed: {problem}.</p>}
    </section>
  );
}
