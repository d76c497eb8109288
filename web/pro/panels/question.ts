// What the watched run waits for, of people, as every part of the page sees it.
import { useEffect, useEffectEvent, useMemo } from "react";
import type { Call } from "../../generated/messages";
import { isOver } from "../../shared/run/controls";
import { isAsking } from "../../shared/run/displayCalls";
import { unseenOf, type Unseen } from "../../shared/run/onDisplays";
import { callThatAsked, waitingForPerson, type PersonWait } from "../../shared/run/waitingForPerson";
import { api, useCore, useSession } from "../client";
import { createStore, useSelected } from "../../page/store";

interface Asked {
  /** The run. */
  readonly id: string;
  readonly call: Call;
}

/** The call that asked, where the page was not there yet. */
const asked = createStore<Asked | undefined, Asked | undefined>(undefined, (_, call) => call);

/** Nothing, or the question that a person has to answer. */
export function usePersonWait(): PersonWait | undefined {
  const core = useCore();
  const services = useSession((s) => s.services);
  const questions = useSession((s) => s.questions);
  const before = useSelected(asked, (call) => call);
  return useMemo(() => waitingForPerson(core, services, before === undefined || before.id !== core?.id ? questions : [...questions, before.call]), [core, services, questions, before]);
}

/** Loads the question that was asked before the page was there. To be used once. */
export function useQuestion(): PersonWait | undefined {
  const core = useCore();
  const wait = usePersonWait();
  const [id, service, call] = [core?.id, wait?.service, wait?.call];
  const isKnown = wait?.question !== undefined;
  // The question is first seen now: later steps need not be looked through.
  const load = useEffectEvent((run: string, asking: string) => callThatAsked({ service: asking, call }, core?.step ?? 0, (from, to) => api.derivations(run, from, to)));
  useEffect(() => {
    if (id === undefined || service === undefined || isKnown) return;
    let current = true;
    load(id, service).then(
      (found) => current && asked.dispatch(found && { id, call: found }),
      () => undefined, // It is shown without its words.
    );
    return () => {
      current = false;
    };
  }, [id, service, call, isKnown]);
  return wait;
}

/** What the run has told displays and none has taken: a text, or a question that nobody can answer. */
export function useUnseen(): Unseen | undefined {
  const core = useCore();
  const told = useSession((s) => s.onDisplays);
  const services = useSession((s) => s.services);
  const unseen = useMemo(() => unseenOf(told, services), [told, services]);
  const isAsked = usePersonWait() !== undefined;
  return isAsked || core === undefined || isOver(core) ? undefined : unseen;
}

/** Whether the run waits for what a person does, and how its status says so. */
export function usePersonStatus(): string | undefined {
  const unseen = useUnseen();
  if (usePersonWait() !== undefined) return "Waiting for a person";
  return unseen !== undefined && isAsking(unseen.call.operation) ? "Waiting for a display" : undefined;
}
