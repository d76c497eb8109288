// Who has the controls of the cell: below the top bar, over the whole width, where there is something to say.
import { ControlBar } from "../../control/ControlBar";
import { SpeedOverride } from "../../control/SpeedOverride";
import { access, ownControls, robotSpeed, useSession } from "../client";
import { useRefusal } from "../login/rights";

const kLost = "the server is not there";

export function Controls() {
  const lost = useSession((s) => s.connection === "lost");
  const take = useRefusal("take_controls");
  const answer = useRefusal("answer_control");
  const speed = useRefusal("set_speed");
  return (
    <ControlBar always={false} address={ownControls} refusal={lost ? kLost : take} refusalToAnswer={lost ? kLost : answer} fetcher={access.fetch} speed={robotSpeed}>
      <SpeedOverride speed={robotSpeed} refusal={lost ? kLost : speed} />
    </ControlBar>
  );
}
