// The arm gives way to a hand while a button is held.
import { HoldButton } from "../../control/HoldButton";
import { canGuide } from "../../shared/control/jog";
import { useSession } from "../client";
import { moving } from "./moving";
import { SavePose } from "./SavePose";

export function GuidePart({ refusal }: { readonly refusal: string | undefined }) {
  const can = useSession((now) => canGuide(now.services));
  if (!can) return <p className="empty">This robot cannot be led by hand.</p>;
  return (
    <div className="guide">
      <p>Take hold of the arm with the other hand first. It gives way while you hold the button, and holds still when you let go. A heavy part in the gripper pulls it down.</p>
      <HoldButton name="Lead the arm by hand" className="is-large" refusal={refusal} onBegin={moving.guide} onEnd={moving.end}>
        Hold to lead the arm
      </HoldButton>
      <SavePose />
    </div>
  );
}
