// What the run has called and not been answered, and since when.
import type { ReactNode } from "react";
import type { Core } from "../../generated/messages";
import { calledText, openCallsOf } from "../../shared/run/openCalls";
import { useSession } from "../client";
import { usePersonWait } from "./question";
import { useCellTime } from "./useCellTime";

/** Rows; more calls are counted in the last one, as a run may have thousands. */
const kMost = 6;

export interface ListedCall {
  readonly service: string;
  readonly operation: string;
  /** What more there is to say of it. */
  readonly about: ReactNode;
}

interface CallListProps {
  readonly calls: readonly ListedCall[];
  /** What is said if there are none. */
  readonly empty?: string;
}

/** Calls that are not answered, of the present or of a moment of the past. */
export function CallList({ calls, empty }: CallListProps) {
  const listed = calls.length > kMost ? calls.slice(0, kMost - 1) : calls;
  return (
    <section aria-label="Open calls">
      <h3>Open calls</h3>
      {calls.length === 0 && empty !== undefined && <p className="quiet">{empty}</p>}
      <ul className="open-calls">
        {listed.map(({ service, operation, about }, i) => (
          // The rows stay while a run goes on, and say something else.
          <li key={i}>
            <code>
              {service}.{operation}
            </code>
            {about}
          </li>
        ))}
        {calls.length > listed.length && <li>and {calls.length - listed.length} more</li>}
      </ul>
    </section>
  );
}

export function OpenCalls({ core }: { readonly core: Core }) {
  const services = useSession((s) => s.services);
  const calls = openCallsOf(core, services);
  const wait = usePersonWait();
  const now = useCellTime(calls.length > 0);
  if (calls.length === 0) return null;
  return <CallList calls={calls.map((call) => ({ service: call.service, operation: call.operation, about: calledText(call, now, wait) }))} />;
}
