// A button that turns a joint, or moves the tool, one way while it is held.
import { partName, type JogPart, type Sign } from "../shared/control/jog";
import { HoldButton } from "./HoldButton";
import type { Moving } from "./moving";

interface Props {
  readonly part: JogPart;
  readonly sign: Sign;
  readonly refusal: string | undefined;
  readonly moving: Moving;
}

export function JogButton({ part, sign, refusal, moving }: Props) {
  const { long } = partName(part);
  return (
    <HoldButton
      name={`${long} ${sign > 0 ? "plus" : "minus"}`}
      title={`${long} ${sign > 0 ? "+" : "−"}: moves while it is held (Space or Enter, too)`}
      refusal={refusal}
      moving={moving}
      onBegin={() => moving.jog(part, sign)}
    >
      {sign > 0 ? "+" : "−"}
    </HoldButton>
  );
}
