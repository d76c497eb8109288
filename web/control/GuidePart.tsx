// The arm gives way to a hand while a button is held.
import type { ReactNode } from "react";
import { canGuide } from "../shared/control/jog";
import type { Hand } from "./hand";
import { HoldButton } from "./HoldButton";

interface Props {
  readonly hand: Hand;
  readonly refusal: string | undefined;
  /** What is done where a hand has led it. */
  readonly children?: ReactNode;
}

export function GuidePart({ hand, refusal, children }: Props) {
  const can = canGuide(hand.useServices());
  if (!can) return <p className="empty">This robot cannot be led by hand.</p>;
  return (
    <div className="guide">
      <p>Take hold of the arm with the other hand first. It gives way while you hold the button, and holds still when you let go. A heavy part in the gripper pulls it down.</p>
      <HoldButton name="Lead the arm by hand" className="is-large" refusal={refusal} moving={hand.moving} onBegin={hand.moving.guide}>
        Hold to lead the arm
      </HoldButton>
      {children}
    </div>
  );
}
