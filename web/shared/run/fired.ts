// The ports that fired in the latest step, for the canvas.
import type { CoreDelta } from "../../generated/messages";

/** Ports that fired in the latest step in which ports fired; `fireCount` counts these steps, so that the same port can flash twice. */
export interface Fired {
  readonly fireCount: number;
  readonly ports: readonly string[];
  /** Whether that step goes on with the next delta. */
  readonly open: boolean;
}

export const noneFired: Fired = { fireCount: 0, ports: [], open: false };

/** A long macro step comes in several deltas. They are one step, unless the core is held within it. */
function goesOn({ core }: CoreDelta): boolean {
  return core.status === "running" && core.micro > 0 && !core.paused;
}

export function applyFired(fired: Fired, delta: CoreDelta): Fired {
  const open = goesOn(delta);
  if (delta.fired.length === 0) return fired.open && !open ? { ...fired, open } : fired;
  if (fired.open) return { ...fired, ports: [...new Set([...fired.ports, ...delta.fired])], open };
  return { fireCount: fired.fireCount + 1, ports: delta.fired, open };
}
