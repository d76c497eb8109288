// A button that turns a joint, or moves the tool, one way while it is held.
import type { ReactNode } from "react";
import { partName, type JogPart, type Sign } from "../shared/control/jog";
import { HoldButton } from "./HoldButton";
import type { Moving } from "./moving";
import { texts } from "./texts";

interface Props {
  readonly part: JogPart;
  readonly sign: Sign;
  /** As people call it; else `Joint 1 plus`. */
  readonly name?: string;
  readonly refusal: string | undefined;
  readonly moving: Moving;
  /** Else its sign. */
  readonly children?: ReactNode;
}

export function JogButton({ part, sign, name, refusal, moving, children }: Props) {
  const { long } = partName(part);
  return (
    <HoldButton
      name={name ?? texts.jog[sign > 0 ? "plus" : "minus"](long)}
      title={texts.hold.title(`${long} ${sign > 0 ? "+" : "−"}`)}
      refusal={refusal}
      moving={moving}
      onBegin={() => moving.jog(part, sign)}
    >
      {children ?? (sign > 0 ? "+" : "−")}
    </HoldButton>
  );
}
