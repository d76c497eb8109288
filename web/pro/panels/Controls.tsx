// Who has the controls of the cell: below the top bar, over the whole width, where there is something to say.
import { ControlBar } from "../../control/ControlBar";
import { access, ownControls, useSession } from "../client";
import { useRefusal } from "../login/rights";

const kLost = "the server is not there";

export function Controls() {
  const lost = useSession((s) => s.connection === "lost");
  const take = useRefusal("take_controls");
  const answer = useRefusal("answer_control");
  return <ControlBar always={false} address={ownControls} refusal={lost ? kLost : take} refusalToAnswer={lost ? kLost : answer} fetcher={access.fetch} />;
}
