// The arm gives way to a hand while a button is held.
import type { ReactNode } from "react";
import { canGuide } from "../shared/control/jog";
import type { Hand } from "./hand";
import { HoldButton } from "./HoldButton";
import { texts } from "./texts";

interface Props {
  readonly hand: Hand;
  readonly refusal: string | undefined;
  /** What is done where a hand has led it. */
  readonly children?: ReactNode;
}

export function GuidePart({ hand, refusal, children }: Props) {
  const can = canGuide(hand.useServices());
  if (!can) return <p className="empty">{texts.guide.cannot}</p>;
  return (
    <div className="guide">
      <p>{texts.guide.about}</p>
      <HoldButton name={texts.guide.name} className="is-large" refusal={refusal} moving={hand.moving} onBegin={hand.moving.guide}>
        {texts.guide.hold}
      </HoldButton>
      {children}
    </div>
  );
}
