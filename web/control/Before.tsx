// What a person does before they move the robot: take the controls, and choose the mode in which it is moved by hand.
import { isStopped } from "../shared/stop/state";
import { useStop } from "../stop/useStop";
import type { Hand } from "./hand";
import { ModeSwitch } from "./ModeSwitch";
import { useControls } from "./page";
import { TakeButton } from "./TakeButton";
import { texts } from "./texts";

export function Before({ hand }: { readonly hand: Hand }) {
  const take = hand.useRefusal("take_controls");
  const mode = hand.useRefusal("set_mode");
  const isHeld = useControls(({ kind }) => kind === "held");
  const stopped = useStop(isStopped);
  const isProgramming = useStop((now) => now.mode === "programming");
  if (stopped) return <p className="notice is-bad">{texts.before.stopped}</p>;
  return (
    <section className="before" aria-label={texts.before.name}>
      <p>
        <b aria-hidden="true">{isHeld ? "✓" : "1"}</b> <span>{texts.before.controls}</span>
        {!isHeld && <TakeButton address={hand.address} refusal={take} />}
      </p>
      <p>
        <b aria-hidden="true">{isProgramming ? "✓" : "2"}</b> <span>{texts.before.mode}</span>
      </p>
      {!isProgramming && <ModeSwitch refusal={mode} fetcher={hand.fetcher} onProblem={hand.onProblem} />}
    </section>
  );
}
