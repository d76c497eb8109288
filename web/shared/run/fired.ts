// The ports that fired in the latest step, for the canvas.
import type { CoreDelta } from "../../generated/messages";

/** Ports that fired in the latest step in which ports fired; `fireCount` counts these steps, so that the same port can flash twice. */
export interface Fired {
  readonly fireCount: number;
  readonly ports: readonly string[];
  /** The number of the macro step, if the next delta may go on with it. */
  readonly open: number | undefined;
}

export const noneFired: Fired = { fireCount: 0, ports: [], open: undefined };

/** A long macro step comes in several deltas. They are one step, unless the core is paused within it. */
function openStep({ core }: CoreDelta): number | undefined {
  return core.status === "running" && core.micro > 0 && !core.paused ? core.step : undefined;
}

export function applyFired(fired: Fired, delta: CoreDelta): Fired {
  const open = openStep(delta);
  const further = fired.open === delta.core.step;
  if (delta.fired.length === 0) return further && open === undefined ? { ...fired, open } : fired;
  if (further) return { ...fired, ports: [...new Set([...fired.ports, ...delta.fired])], open };
  return { fireCount: fired.fireCount + 1, ports: delta.fired, open };
}
