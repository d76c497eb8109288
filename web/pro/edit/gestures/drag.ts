// Dragging with the pointer: it begins when the pointer has moved a little, and is given up by Esc, by the browser (pointercancel), and when
// the window loses the focus. A press without a move stays a click.
import type { ScreenPoint } from "../prompt";

/** What is held meanwhile. */
export type Held = Pick<MouseEvent, "altKey">;

export interface Drag {
  /** The pointer is at another place; called first when the drag begins. */
  readonly move: (at: ScreenPoint, held: Held) => void;
  readonly drop: (at: ScreenPoint, held: Held) => void;
  /** After a drop, and when it is given up. */
  readonly end: () => void;
}

/** A press with less of a move is a click [px]. */
const kThreshold = 4;

/** The click that follows a drag is none. */
function swallowClick(): void {
  const swallow = (event: MouseEvent) => event.stopPropagation();
  addEventListener("click", swallow, { capture: true, once: true });
  setTimeout(() => removeEventListener("click", swallow, true));
}

/** Follows the pointer that was pressed. `begin` makes what is done; nothing: it cannot be dragged. */
export function followPointer({ pointerId, clientX, clientY }: Pick<PointerEvent, "pointerId" | "clientX" | "clientY">, begin: () => Drag | undefined): void {
  let drag: Drag | undefined;
  const stop = new AbortController();
  const end = () => {
    stop.abort();
    drag?.end();
  };
  const move = (event: PointerEvent) => {
    if (event.pointerId !== pointerId) return;
    if (drag === undefined) {
      if (Math.hypot(event.clientX - clientX, event.clientY - clientY) < kThreshold) return;
      drag = begin();
      if (drag === undefined) end();
    }
    drag?.move({ x: event.clientX, y: event.clientY }, event);
  };
  const up = (event: PointerEvent) => {
    if (event.pointerId !== pointerId) return;
    const dropped = drag;
    if (dropped !== undefined) swallowClick();
    end();
    dropped?.drop({ x: event.clientX, y: event.clientY }, event);
  };
  const press = (event: KeyboardEvent) => {
    if (drag === undefined) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    if (event.key === "Escape") end();
  };
  const { signal } = stop;
  addEventListener("pointermove", move, { signal });
  addEventListener("pointerup", up, { signal });
  addEventListener("pointercancel", (event) => event.pointerId === pointerId && end(), { signal });
  addEventListener("blur", end, { signal });
  addEventListener("keydown", press, { capture: true, signal });
}
