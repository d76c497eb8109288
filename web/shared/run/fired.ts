// The ports that fired in the latest step, for the canvas.
import type { CoreDelta } from "../../generated/messages";

/** Ports that fired in the latest step in which ports fired, and in those that are shown in the same frame of the page; `fireCount` counts
 *  what is shown one after the other, so that the same port can flash twice. */
export interface Fired {
  readonly fireCount: number;
  readonly ports: readonly string[];
  /** The number of the macro step, if the next delta may go on with it. */
  readonly open: number | undefined;
  /** The frame of the page in which they are shown; none: steps are shown one by one. */
  readonly frame: number | undefined;
}

export const noneFired: Fired = { fireCount: 0, ports: [], open: undefined, frame: undefined };

/** A long macro step comes in several deltas. They are one step, unless the core is paused within it. */
function openStep({ core }: CoreDelta): number | undefined {
  return core.status === "running" && core.micro > 0 && !core.paused ? core.step : undefined;
}

/** `frame`: in which the delta is shown, together with all others of the same frame. */
export function applyFired(fired: Fired, delta: CoreDelta, frame?: number): Fired {
  const open = openStep(delta);
  const further = fired.open === delta.core.step;
  if (delta.fired.length === 0) return further && open === undefined ? { ...fired, open } : fired;
  const together = further || (frame !== undefined && fired.frame === frame);
  if (together) return { ...fired, ports: [...new Set([...fired.ports, ...delta.fired])], open, frame };
  return { fireCount: fired.fireCount + 1, ports: delta.fired, open, frame };
}
