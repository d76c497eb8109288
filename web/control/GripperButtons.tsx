// The gripper, opened and closed by hand.
import { useState } from "react";
import { controls } from "./page";
import type { Movable } from "../shared/control/jog";
import { messageOf } from "../shared/messageOf";
import { texts } from "./texts";

/** Slow [m/s]. */
const kSpeed = 0.05;

interface Props {
  readonly gripper: NonNullable<Movable["gripper"]>;
  readonly refusal: string | undefined;
}

export function GripperButtons({ gripper: { key, open, close }, refusal }: Props) {
  const [busy, setBusy] = useState<"open" | "close">();
  const [said, setSaid] = useState("");
  const move = async (which: "open" | "close", operation: string) => {
    setBusy(which);
    setSaid("");
    try {
      // `release` and `grasp` (services/gripper) can be told how fast.
      await controls.call(key, operation, operation === which ? {} : { speed: kSpeed });
      setSaid(which === "open" ? texts.gripper.opened : texts.gripper.closed);
    } catch (error) {
      setSaid(texts.gripper.failed(messageOf(error)));
    } finally {
      setBusy(undefined);
    }
  };
  const disabled = refusal !== undefined || busy !== undefined;
  return (
    <div className="manual-gripper" role="group" aria-label={texts.gripper.name(key)}>
      <h3>{texts.gripper.title}</h3>
      <button type="button" data-of={texts.gripper.ofButton} disabled={disabled} title={refusal} onClick={() => void move("open", open)}>
        {busy === "open" ? texts.gripper.opening : texts.gripper.open}
      </button>
      <button type="button" data-of={texts.gripper.ofButton} disabled={disabled} title={refusal} onClick={() => void move("close", close)}>
        {busy === "close" ? texts.gripper.closing : texts.gripper.close}
      </button>
      <small role="status">{said}</small>
    </div>
  );
}
