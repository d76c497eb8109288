// A button that moves the robot while it is held, by pointer or by key.
import { useEffect, useRef, useState, type ReactNode } from "react";
import { useSelected } from "../page/store";
import { watchFingers } from "./fingers";
import type { Moving } from "./moving";
import { texts } from "./texts";

interface Props {
  /** What it does while it is held: `Joint 1 plus`. */
  readonly name: string;
  readonly title?: string;
  readonly className?: string;
  /** Why nothing is moved now. */
  readonly refusal: string | undefined;
  readonly moving: Moving;
  /** Begins the motion, which ends with whatever may mean that nobody holds the button; also when the button goes. */
  readonly onBegin: () => void;
  readonly children: ReactNode;
}

const isHoldKey = (key: string): boolean => key === " " || key === "Enter";

export function HoldButton({ name, title, className = "", refusal, moving, onBegin, children }: Props) {
  const [held, setHeld] = useState(false);
  const isHeld = useRef(false);
  const isMoved = useSelected(moving.store, (now) => now.refused === undefined);
  /** The pointer that holds it; nothing: a key does. */
  const pointer = useRef<number>(undefined);
  const begin = (by?: number) => {
    if (isHeld.current) return;
    isHeld.current = true;
    pointer.current = by;
    setHeld(true);
    onBegin();
  };
  const end = () => {
    if (!isHeld.current) return;
    isHeld.current = false;
    setHeld(false);
    moving.end();
  };
  const isRefused = refusal !== undefined;
  // Also when the button goes, or may not be pressed any more.
  useEffect(() => {
    if (!held) return;
    const over = () => {
      isHeld.current = false;
      setHeld(false);
      moving.end();
    };
    if (isRefused) {
      over();
      return;
    }
    const events = [[window, "blur"], [document, "visibilitychange"], [window, "pagehide"]] as const;
    for (const [target, event] of events) target.addEventListener(event, over);
    const endWatch = watchFingers(window, pointer.current, () => {
      over();
      moving.refuse(texts.hold.twoFingers);
    });
    return () => {
      endWatch();
      for (const [target, event] of events) target.removeEventListener(event, over);
      moving.end();
    };
  }, [held, isRefused, moving]);
  return (
    <button
      type="button"
      className={`hold${held && isMoved ? " is-held" : ""} ${className}`}
      disabled={isRefused}
      aria-label={texts.hold.name(name)}
      title={refusal ?? title ?? texts.hold.title(name)}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        if (!event.isPrimary) {
          moving.refuse(texts.hold.twoFingers);
          return;
        }
        event.currentTarget.setPointerCapture(event.pointerId);
        begin(event.pointerId);
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
      {children}
    </button>
  );
}
