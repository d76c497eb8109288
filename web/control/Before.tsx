// What a person does before they move the robot: take the controls, and choose the mode in which it is moved by hand.
import { isStopped } from "../shared/stop/state";
import { useStop } from "../stop/useStop";
import type { Hand } from "./hand";
import { ModeSwitch } from "./ModeSwitch";
import { useControls } from "./page";
import { TakeButton } from "./TakeButton";

export function Before({ hand }: { readonly hand: Hand }) {
  const take = hand.useRefusal("take_controls");
  const mode = hand.useRefusal("set_mode");
  const isHeld = useControls(({ kind }) => kind === "held");
  const stopped = useStop(isStopped);
  const isProgramming = useStop((now) => now.mode === "programming");
  if (stopped) return <p className="notice is-bad">The cell is stopped: reset the stop first.</p>;
  return (
    <section className="before" aria-label="Before you move the robot">
      <p>
        <b aria-hidden="true">{isHeld ? "✓" : "1"}</b> <span>One person at a time moves the robot.</span>
        {!isHeld && <TakeButton address={hand.address} refusal={take} />}
      </p>
      <p>
        <b aria-hidden="true">{isProgramming ? "✓" : "2"}</b> <span>In programming mode it is moved by hand, at most 250 mm/s.</span>
      </p>
      {!isProgramming && <ModeSwitch refusal={mode} fetcher={hand.fetcher} onProblem={hand.onProblem} />}
    </section>
  );
}
