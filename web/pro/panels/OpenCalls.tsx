// What the run has called and not been answered, and since when.
import { useEffect, useState } from "react";
import type { Core } from "../../generated/messages";
import { calledText, openCallsOf } from "../../shared/run/openCalls";
import { cellPose, useSession } from "../client";

/** The time of the cell, read some times a second while something depends on it. */
function useCellTime(wanted: boolean): number | undefined {
  const [time, setTime] = useState<number>();
  useEffect(() => {
    if (!wanted) return;
    const read = () => setTime(cellPose.get()?.time);
    read();
    const timer = setInterval(read, 300);
    return () => clearInterval(timer);
  }, [wanted]);
  return time;
}

export function OpenCalls({ core }: { readonly core: Core }) {
  const services = useSession((s) => s.services);
  const calls = openCallsOf(core, services);
  const now = useCellTime(calls.length > 0);
  if (calls.length === 0) return null;
  return (
    <section aria-label="Open calls">
      <h3>Open calls</h3>
      <ul className="past-list">
        {calls.map((call) => (
          <li key={call.call}>
            <code>
              {call.service}.{call.operation}
            </code>
            <small>{calledText(call, now)}</small>
          </li>
        ))}
      </ul>
    </section>
  );
}
