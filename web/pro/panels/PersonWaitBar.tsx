// The run waits for a person: what is asked, the answers, and the way to the page of a display.
import { useEffect, useEffectEvent, useMemo, useState } from "react";
import type { TraceStep } from "../../generated/messages";
import { displayAddress, stepThatAsked, waitingForPerson, type PersonWait } from "../../shared/run/waitingForPerson";
import { api, useCore, useSession } from "../client";
import { AnswerHere } from "./AnswerHere";
import { Icon } from "./Icon";

/** What the watched run waits for; nothing, or a person. `asked`: a step that the page has besides those of the derivation. */
export function usePersonWait(asked?: TraceStep): PersonWait | undefined {
  const core = useCore();
  const services = useSession((s) => s.services);
  const steps = useSession((s) => s.steps);
  return useMemo(() => waitingForPerson(core, services, asked === undefined ? steps : [...steps, asked]), [core, services, steps, asked]);
}

/** What waits for a person, and what is asked: of a run whose derivations are not sent, or that has gone on for long, the step that asked is loaded. */
function useQuestion(): PersonWait | undefined {
  const [asked, setAsked] = useState<TraceStep>();
  const core = useCore();
  const wait = usePersonWait(asked);
  const [id, service, call] = [core?.id, wait?.service, wait?.call];
  const isKnown = wait?.question !== undefined;
  // The question is first seen now: later steps need not be looked through.
  const load = useEffectEvent((run: string, asking: string) => stepThatAsked({ service: asking, call }, core?.step ?? 0, (from, to) => api.derivations(run, from, to)));
  useEffect(() => {
    if (id === undefined || service === undefined || isKnown) return;
    let current = true;
    load(id, service).then(
      (found) => current && setAsked(found),
      () => undefined, // It is shown without its words.
    );
    return () => {
      current = false;
    };
  }, [id, service, call, isKnown]);
  return wait;
}

export function PersonWaitBar() {
  const wait = useQuestion();
  if (wait === undefined) return null;
  return (
    <div className="interruption person-wait" role="alert" aria-label="Waiting for a person">
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
      {wait.answers !== undefined && <AnswerHere key={`${wait.service} ${wait.call}`} wait={wait} answers={wait.answers} />}
    </div>
  );
}
