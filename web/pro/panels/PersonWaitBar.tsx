// The run waits for a person: what is asked, and the way to the page that takes the answer.
import { useMemo } from "react";
import { displayAddress, waitingForPerson, type PersonWait } from "../../shared/run/waitingForPerson";
import { useCore, useSession } from "../client";
import { Icon } from "./Icon";

/** What the watched run waits for; nothing, or a person. */
export function usePersonWait(): PersonWait | undefined {
  const core = useCore();
  const services = useSession((s) => s.services);
  const steps = useSession((s) => s.steps);
  return useMemo(() => waitingForPerson(core, services, steps), [core, services, steps]);
}

export function PersonWaitBar() {
  const wait = usePersonWait();
  if (wait === undefined) return null;
  return (
    <div className="interruption" role="alert" aria-label="Waiting for a person">
      <Icon name="interrupted" />
      <div>
        <strong>Waiting for a person{wait.question === undefined ? "" : `: ${wait.question}`}</strong>
        <p>
          Asked by <code>{`svc.${wait.service}.${wait.operation}`}</code> on {wait.display === "all" ? "every display" : `the display ${wait.display}`}.{" "}
          <a href={displayAddress(wait)} target="_blank" rel="noreferrer">
            Open a display
          </a>
        </p>
      </div>
    </div>
  );
}
