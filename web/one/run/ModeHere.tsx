// In programming mode, as after a pose was taught: what that means for a run, and the way back.
import { ModeSwitch } from "../../control/ModeSwitch";
import { kModeMeans } from "../../shared/control/texts";
import { useStop } from "../../stop/useStop";
import { hand } from "../hand";
import { texts } from "../texts";

export function ModeHere() {
  const isProgramming = useStop((now) => now.mode === "programming");
  const refusal = hand.useRefusal("set_mode");
  if (!isProgramming) return null;
  return (
    <section className="mode-here" aria-label={texts.runView.mode}>
      <p className="doc">{kModeMeans.programming}</p>
      <ModeSwitch refusal={refusal} fetcher={hand.fetcher} onProblem={hand.onProblem} />
    </section>
  );
}
