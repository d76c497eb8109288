// How fast what is held moves.
import { kShares, speedText } from "../shared/control/jog";
import type { Hand } from "./hand";
import { texts } from "./texts";

export function SpeedSlider({ hand }: { readonly hand: Hand }) {
  const share = hand.useMoving((now) => now.share);
  return (
    <label className="slider">
      <span>{texts.jog.speed}</span>
      <input type="range" min={kShares.least} max={kShares.most} step={kShares.step} value={share} aria-valuetext={speedText(share)} onChange={(event) => hand.moving.set({ share: Number(event.target.value) })} />
      <output>{speedText(share)}</output>
    </label>
  );
}
