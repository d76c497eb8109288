// The cell is stopped: below the top bar, over the whole width.
import { StoppedBanner } from "../../stop/StoppedBanner";
import { access, useSession } from "../client";
import { useRefusal } from "../login/rights";

export function StoppedCell() {
  const lost = useSession((s) => s.connection === "lost");
  const refusal = useRefusal("reset_stop");
  return <StoppedBanner refusal={lost ? "the server is not there" : refusal} fetcher={access.fetch} />;
}
