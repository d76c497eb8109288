// Back and forward, in the run bar: they move what is shown, never the run.
import { keysOf } from "../../shared/session/shortcuts";
import { useCore, useSession } from "../client";
import { Icon } from "../panels/Icon";
import { move } from "./past";

export function PastButtons() {
  const core = useCore();
  const lost = useSession((s) => s.connection === "lost");
  const past = useSession((s) => s.past?.past);
  if (core === undefined) return null;
  const begun = core.step > 0;
  const first = past?.step === 1 && past.micro === 0;
  return (
    <div className="past-buttons" role="group" aria-label="What is shown">
      <button type="button" disabled={!begun || lost || first} aria-label="Back" title={`Back by a micro step: what is shown, not the run (${keysOf("back")})`} aria-keyshortcuts={keysOf("back")} onClick={() => move("back")}>
        <Icon name="back" />
      </button>
      <button type="button" disabled={past === undefined || lost} aria-label="Forward" title={`Forward again (${keysOf("forward")})`} aria-keyshortcuts={keysOf("forward")} onClick={() => move("forward")}>
        <Icon name="forward" />
      </button>
    </div>
  );
}
