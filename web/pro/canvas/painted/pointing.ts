// Mouse, touchpad and fingers on the painted canvas: a drag moves it, a wheel or a pinch zooms, a click or double click is passed on.
import type { Point } from "../../../shared/drawing/drawing";
import { movedBy, wheelFactor, zoomedAt } from "../../../shared/drawing/movement";
import type { Camera } from "./camera";

export interface Pointing {
  /** The user has moved or zoomed the drawing. */
  readonly onMove: () => void;
  readonly onClick: (event: MouseEvent) => void;
  readonly onDoubleClick: (event: MouseEvent) => void;
  /** The pointer is somewhere without a pressed button; nothing: it has left. */
  readonly onHover: (event: PointerEvent | undefined) => void;
}

/** A press that moves less is a click [px]. */
const kStill = 4;

export function listenToPointers(element: HTMLElement, camera: Camera, pointing: Pointing): () => void {
  const pressed = new Map<number, Point>();
  let dragged = false;
  let travelled = 0;

  const local = ({ x, y }: Point): Point => {
    const { left, top } = element.getBoundingClientRect();
    return { x: x - left, y: y - top };
  };
  const down = (event: PointerEvent) => {
    if (event.defaultPrevented || event.button > 1) return;
    pressed.set(event.pointerId, { x: event.clientX, y: event.clientY });
    [dragged, travelled] = [false, 0];
  };
  const pinch = (before: Point, now: Point, other: Point) => {
    const distance = (a: Point, b: Point) => Math.hypot(a.x - b.x, a.y - b.y);
    const middle = { x: (now.x + other.x) / 2, y: (now.y + other.y) / 2 };
    const moved = movedBy(camera.viewport(), { x: (now.x - before.x) / 2, y: (now.y - before.y) / 2 });
    camera.show(zoomedAt(moved, local(middle), distance(now, other) / Math.max(1, distance(before, other))));
  };
  const move = (event: PointerEvent) => {
    const before = pressed.get(event.pointerId);
    if (before === undefined) {
      if (event.buttons === 0) pointing.onHover(event);
      return;
    }
    const now = { x: event.clientX, y: event.clientY };
    travelled += Math.hypot(now.x - before.x, now.y - before.y);
    if (!dragged && travelled < kStill) return;
    if (!dragged) element.setPointerCapture(event.pointerId);
    dragged = true;
    pressed.set(event.pointerId, now);
    pointing.onMove();
    const other = [...pressed].find(([id]) => id !== event.pointerId)?.[1];
    if (other === undefined) camera.show(movedBy(camera.viewport(), { x: now.x - before.x, y: now.y - before.y }));
    else pinch(before, now, other);
  };
  const up = (event: PointerEvent) => void pressed.delete(event.pointerId);
  const click = (event: MouseEvent) => {
    if (dragged) event.stopPropagation();
    else pointing.onClick(event);
    dragged = false;
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    pointing.onMove();
    camera.show(zoomedAt(camera.viewport(), local({ x: event.clientX, y: event.clientY }), wheelFactor(event)));
  };
  const leave = () => pointing.onHover(undefined);
  // A middle press would start the browser's own scrolling.
  const middle = (event: MouseEvent) => event.button === 1 && event.preventDefault();

  const stop = new AbortController();
  const { signal } = stop;
  element.addEventListener("pointerdown", down, { signal });
  element.addEventListener("pointermove", move, { signal });
  for (const over of ["pointerup", "pointercancel"] as const) element.addEventListener(over, up, { signal });
  element.addEventListener("pointerleave", leave, { signal });
  element.addEventListener("click", click, { signal });
  element.addEventListener("dblclick", pointing.onDoubleClick, { signal });
  element.addEventListener("mousedown", middle, { signal });
  element.addEventListener("wheel", wheel, { passive: false, signal });
  return () => stop.abort();
}
