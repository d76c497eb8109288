// Each joint, or the tool along and around its axes: a button for either way, which moves while it is held.
import { kJointParts, kToolParts, partName } from "../shared/control/jog";
import type { Hand } from "./hand";
import { JogButton } from "./JogButton";

interface Props {
  readonly hand: Hand;
  readonly kind: "joints" | "tool";
  readonly refusal: string | undefined;
}

export function JogPart({ hand, kind, refusal }: Props) {
  return (
    <div className={`jog is-${kind}`} role="group" aria-label={kind === "joints" ? "Joints" : "Tool"}>
      {kind === "tool" && <FrameChoice hand={hand} />}
      {(kind === "joints" ? kJointParts : kToolParts).map((part) => {
        const { short, long } = partName(part);
        return (
          <div key={long} className="jog-row">
            <JogButton part={part} sign={-1} refusal={refusal} moving={hand.moving} />
            <b title={long}>{kind === "joints" ? long : short}</b>
            <JogButton part={part} sign={1} refusal={refusal} moving={hand.moving} />
          </div>
        );
      })}
    </div>
  );
}

function FrameChoice({ hand }: { readonly hand: Hand }) {
  const frame = hand.useMoving((now) => now.frame);
  return (
    <div className="frames" role="group" aria-label="Along the axes of">
      {(["o", "tool"] as const).map((each) => (
        <button key={each} type="button" aria-pressed={frame === each} onClick={() => hand.moving.set({ frame: each })}>
          {each === "o" ? "Axes of the cell" : "Axes of the tool"}
        </button>
      ))}
    </div>
  );
}
