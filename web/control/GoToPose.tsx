// The arm goes to a taught pose while a button is held, straight in its joints.
import type { TaughtPose } from "../shared/pendant/poses";
import type { Hand } from "./hand";
import { HoldButton } from "./HoldButton";

interface Props {
  readonly hand: Hand;
  readonly pose: TaughtPose;
  readonly refusal: string | undefined;
}

export function GoToPose({ hand, pose: { name, q }, refusal }: Props) {
  return (
    <HoldButton name={`Go to ${name}`} className="is-go" title="The arm goes there while it is held, straight in its joints; it avoids nothing" refusal={refusal} moving={hand.moving} onBegin={() => hand.moving.goTo(q)}>
      Go to “{name}”
    </HoldButton>
  );
}
