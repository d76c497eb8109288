// A button that moves the robot while it is held, by pointer or by key.
import { useEffect, useRef, useState, type ReactNode } from "react";

interface Props {
  /** What it does while it is held: `Joint 1 plus`. */
  readonly name: string;
  readonly title?: string;
  readonly className?: string;
  /** Why nothing is moved now. */
  readonly refusal: string | undefined;
  readonly onBegin: () => void;
  /** Whatever may mean that nobody holds it; also when the button goes. */
  readonly onEnd: () => void;
  readonly children: ReactNode;
}

const isHoldKey = (key: string): boolean => key === " " || key === "Enter";

export function HoldButton({ name, title, className = "", refusal, onBegin, onEnd, children }: Props) {
  const [held, setHeld] = useState(false);
  const isHeld = useRef(false);
  const begin = () => {
    if (isHeld.current) return;
    isHeld.current = true;
    setHeld(true);
    onBegin();
  };
  const end = () => {
    if (!isHeld.current) return;
    isHeld.current = false;
    setHeld(false);
    onEnd();
  };
  const ending = useRef(onEnd);
  useEffect(() => {
    ending.current = onEnd;
  });
  const isRefused = refusal !== undefined;
  // Also when the button goes, or may not be pressed any more.
  useEffect(() => {
    if (!held) return;
    const over = () => {
      isHeld.current = false;
      setHeld(false);
      ending.current();
    };
    if (isRefused) {
      over();
      return;
    }
    const events = [[window, "blur"], [document, "visibilitychange"], [window, "pagehide"]] as const;
    for (const [target, event] of events) target.addEventListener(event, over);
    return () => {
      for (const [target, event] of events) target.removeEventListener(event, over);
      ending.current();
    };
  }, [held, isRefused]);
  return (
    <button
      type="button"
      className={`hold${held ? " is-held" : ""} ${className}`}
      disabled={isRefused}
      aria-label={`${name}, while held`}
      title={refusal ?? title ?? `${name}: moves while it is held (Space or Enter, too)`}
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
      {children}
    </button>
  );
}
