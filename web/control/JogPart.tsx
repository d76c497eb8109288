// Each joint, or the tool along and around its axes: a button for either way, with the word for it, which moves while it is held.
import { jointNames, wayName, wayOf } from "../shared/control/directions";
import { kJointParts, kToolParts, partName, type JogPart as Part, type Sign } from "../shared/control/jog";
import type { Hand } from "./hand";
import { JogButton } from "./JogButton";
import { texts } from "./texts";

interface Props {
  readonly hand: Hand;
  readonly kind: "joints" | "tool";
  readonly refusal: string | undefined;
}

export function JogPart({ hand, kind, refusal }: Props) {
  const frame = hand.useMoving((now) => now.frame);
  const joints = jointNames(hand.useServices());
  const button = (part: Part, sign: Sign) => {
    const way = wayOf(part, sign, frame);
    return (
      <JogButton part={part} sign={sign} name={wayName(part, sign, frame, joints)} refusal={refusal} moving={hand.moving}>
        {way === undefined ? undefined : (
          <span className="way">
            {way}{" "}
            <small>
              {sign > 0 ? "+" : "−"}
              {partName(part).short}
            </small>
          </span>
        )}
      </JogButton>
    );
  };
  return (
    <div className={`jog is-${kind}`} role="group" aria-label={texts.jog[kind]}>
      {kind === "tool" && <FrameChoice hand={hand} />}
      {(kind === "joints" ? kJointParts : kToolParts).map((part) => {
        const { short, long } = partName(part);
        const joint = part.kind === "joint" ? joints[part.joint] : undefined;
        return (
          <div key={long} className="jog-row">
            {button(part, -1)}
            <b title={long}>
              {kind === "tool" ? short : (joint ?? long)}
              {joint !== undefined && <small> {short}</small>}
            </b>
            {button(part, 1)}
          </div>
        );
      })}
    </div>
  );
}

function FrameChoice({ hand }: { readonly hand: Hand }) {
  const frame = hand.useMoving((now) => now.frame);
  return (
    <div className="frames" role="group" aria-label={texts.jog.frames}>
      {(["o", "tool"] as const).map((each) => (
        <button key={each} type="button" aria-pressed={frame === each} onClick={() => hand.moving.set({ frame: each })}>
          {each === "o" ? texts.jog.ofCell : texts.jog.ofTool}
        </button>
      ))}
    </div>
  );
}
