// Sets the speed of the robot where it is moved by hand, while that is not the whole: below the buttons that move it, which stay where they are. In a run, its view does.
import { SpeedOverride } from "../../control/SpeedOverride";
import { useSelected } from "../../page/store";
import { speedSign } from "../../shared/control/speed";
import { robotSpeed, useRefusal, useSession } from "../client";
import { useIsRun } from "../place";
import { texts } from "../texts";

export function SpeedHere() {
  const isSlow = useSelected(robotSpeed.store, ({ share }) => speedSign(share) !== undefined);
  const isRun = useIsRun();
  const refusal = useRefusal("set_speed");
  const away = useSession((s) => (s.connection === "open" ? undefined : texts.frame.away));
  return isSlow && !isRun ? <SpeedOverride speed={robotSpeed} refusal={away ?? refusal} /> : null;
}
