// The view of the painted canvas: where it is, and its gradual movements. Who listens is told in a frame of the page, once of all that has happened
// since: what they write is not read before the frame is made, else the browser would compute styles for each event of the pointer.
import type { Viewport } from "../../../shared/drawing/fit";
import { between } from "../../../shared/drawing/movement";

export interface Camera {
  readonly viewport: () => Viewport;
  /** Moves there, gradually over `duration` [ms]; ends a movement that is under way. */
  readonly show: (viewport: Viewport, duration?: number) => void;
  readonly listen: (listener: () => void) => () => void;
}

const eased = (share: number): number => 1 - (1 - share) ** 3;

export function createCamera(): Camera {
  let now: Viewport = { x: 0, y: 0, zoom: 1 };
  let next = 0;
  const listeners = new Set<() => void>();
  const tell = () => listeners.forEach((listener) => listener());
  const show = (to: Viewport, duration = 0) => {
    cancelAnimationFrame(next);
    if (duration === 0 || matchMedia("(prefers-reduced-motion: reduce)").matches) {
      now = to;
      next = requestAnimationFrame(tell);
      return;
    }
    const from = now;
    const begun = performance.now();
    const step = () => {
      const share = Math.min(1, (performance.now() - begun) / duration);
      now = between(from, to, eased(share));
      if (share < 1) next = requestAnimationFrame(step);
      tell();
    };
    next = requestAnimationFrame(step);
  };
  const listen = (listener: () => void) => {
    listeners.add(listener);
    return () => listeners.delete(listener);
  };
  return { viewport: () => now, show, listen };
}
