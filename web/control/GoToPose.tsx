// The arm goes to a taught pose while a button is held, straight in its joints.
import type { TaughtPose } from "../shared/pendant/poses";
import type { Hand } from "./hand";
import { HoldButton } from "./HoldButton";
import { texts } from "./texts";

interface Props {
  readonly hand: Hand;
  readonly pose: TaughtPose;
  readonly refusal: string | undefined;
}

export function GoToPose({ hand, pose: { name, q }, refusal }: Props) {
  return (
    <HoldButton name={texts.poses.goTo(name)} className="is-go" title={texts.poses.goToTitle} refusal={refusal} moving={hand.moving} onBegin={() => hand.moving.goTo(q)}>
      {texts.poses.goToQuoted(name)}
    </HoldButton>
  );
}
