// That the robot goes slower than its tasks say, or stands still for that: it outlives who has set it so.
import type { ReactNode } from "react";
import { speedSign } from "../shared/control/speed";
import { texts } from "./texts";

interface Props {
  readonly sign: NonNullable<ReturnType<typeof speedSign>>;
  /** Or under `Run`. */
  readonly isSetHere: boolean;
  /** Sets it. */
  readonly children: ReactNode;
}

export function SpeedSign({ sign: { title, means, stands }, isSetHere, children }: Props) {
  const todo = isSetHere ? texts.speed.setHere : texts.speed.setUnderRun;
  return (
    <div className={`speed-sign${stands ? " is-standing" : ""}`}>
      <p key={title} role={stands ? "alert" : "status"}>
        <strong>{title}</strong> <span>{stands ? todo(means) : means}</span>
      </p>
      {children}
    </div>
  );
}
