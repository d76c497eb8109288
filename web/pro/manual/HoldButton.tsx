// A button that moves the robot while it is held, by pointer or by key.
import { useEffect, useRef, useState } from "react";
import type { JogPart, Sign } from "../../shared/control/jog";
import { beginMotion, endMotion } from "./moving";

interface Props {
  readonly part: JogPart;
  readonly sign: Sign;
  /** What moves: `Joint 1`. */
  readonly name: string;
  /** Why nothing is moved now. */
  readonly refusal: string | undefined;
}

const isHoldKey = (key: string): boolean => key === " " || key === "Enter";

export function HoldButton({ part, sign, name, refusal }: Props) {
  const [held, setHeld] = useState(false);
  const isHeld = useRef(false);
  const begin = () => {
    if (isHeld.current) return;
    isHeld.current = true;
    setHeld(true);
    beginMotion(part, sign);
  };
  const end = () => {
    if (!isHeld.current) return;
    isHeld.current = false;
    setHeld(false);
    endMotion();
  };
  const isRefused = refusal !== undefined;
  // Also when the button goes, or may not be pressed any more.
  useEffect(() => {
    if (!held) return;
    const over = () => {
      isHeld.current = false;
      setHeld(false);
      endMotion();
    };
    if (isRefused) {
      over();
      return;
    }
    const events = [[window, "blur"], [document, "visibilitychange"], [window, "pagehide"]] as const;
    for (const [target, event] of events) target.addEventListener(event, over);
    return () => {
      for (const [target, event] of events) target.removeEventListener(event, over);
      endMotion();
    };
  }, [held, isRefused]);
  return (
    <button
      type="button"
      className={`hold${held ? " is-held" : ""}`}
      disabled={isRefused}
      aria-label={`${name} ${sign > 0 ? "plus" : "minus"}, while held`}
      title={refusal ?? `${name} ${sign > 0 ? "+" : "−"}: moves while it is held (Space or Enter, too)`}
      onPointerDown={(event) => {
        if (event.button !== 0 || !event.isPrimary) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        begin();
      }}
      onPointerUp={end}
      onPointerCancel={end}
      onLostPointerCapture={end}
      onBlur={end}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (!isHoldKey(event.key)) return;
        event.preventDefault();
        event.stopPropagation();
        if (!event.repeat) begin();
      }}
      onKeyUp={(event) => {
        if (!isHoldKey(event.key)) return;
        event.preventDefault();
        end();
      }}
    >
      {sign > 0 ? "+" : "−"}
    </button>
  );
}
