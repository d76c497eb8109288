// The macro steps of the shown run, loaded in parts of which only what is shown is kept.
import { useEffect, useEffectEvent, useRef, useState } from "react";
import type { TraceStep } from "../../generated/messages";
import { watchedCore } from "../../shared/session/session";
import { api, session, sourceOf, useSession } from "../client";
import { messageOf } from "../../shared/messageOf";

/** So many macro steps are shown, the last ones. */
export const kMostSteps = 1000;
/** The server takes so many in a request. */
const kPart = 100;
/** A run that goes on is asked for what is new at most this often [ms]. */
const kEvery = 1000;

/** What is kept of a macro step. */
interface Kept {
  readonly step: number;
}

export interface LoadedSteps<T extends Kept> {
  readonly id: string;
  readonly steps: readonly T[];
  readonly failed?: string;
}

async function loadPart<T extends Kept>(id: string, known: readonly T[], last: number, keep: (step: TraceStep) => T): Promise<readonly T[]> {
  // The last one that is known may have gone on since.
  const from = Math.max(1, last - kMostSteps + 1, known.at(-1)?.step ?? 1);
  const added = (await api.derivations(id, from, Math.min(last, from + kPart - 1), sourceOf(session.get()))).map(keep);
  return [...known.filter(({ step }) => step < from && step > last - kMostSteps), ...added];
}

/** Macro steps of the watched run, which grow with it; nothing before the first part is here. `keep` is always the same. */
export function useSteps<T extends Kept>(keep: (step: TraceStep) => T): LoadedSteps<T> | undefined {
  const id = useSession((s) => s.watched);
  const last = useSession((s) => watchedCore(s)?.step ?? 0);
  const micro = useSession((s) => watchedCore(s)?.micro ?? 0);
  const [line, setLine] = useState<LoadedSteps<T>>();
  const shown = line?.id === id ? line : undefined;
  const have = shown?.steps.at(-1)?.step ?? 0;
  /** One request at a time, and none is given up because the run goes on: it may go on faster than the server answers. `moment`: what is loaded. */
  const asked = useRef({ busy: false, at: -kEvery, moment: "" });
  const load = useEffectEvent(async (of: string, to: number, moment: string) => {
    const steps = shown?.steps ?? [];
    Object.assign(asked.current, { busy: true, at: performance.now(), moment });
    const next = await loadPart(of, steps, to, keep).then(
      (all): LoadedSteps<T> => ({ id: of, steps: all }),
      (error: unknown): LoadedSteps<T> => ({ id: of, steps, failed: messageOf(error) }),
    );
    asked.current.busy = false;
    setLine(next);
  });
  useEffect(() => {
    const moment = `${id}/${last}.${micro}`;
    const { busy, at, moment: before } = asked.current;
    const complete = before === moment && (have >= last || shown?.failed !== undefined);
    if (id === undefined || last === 0 || busy || complete) return;
    // Parts that are missing come at once.
    const wait = shown?.failed === undefined && (have === 0 || last - have >= kPart) ? 0 : Math.max(0, at + kEvery - performance.now());
    const timer = setTimeout(() => void load(id, last, moment), wait);
    return () => clearTimeout(timer);
    // Also with the answer of a run from which the page has turned away, which is not shown: until then the one it turned to could not be asked for.
  }, [id, last, micro, have, shown, line]);
  return shown;
}

/** Whether steps are still to come: the run has some, and none is here. */
export function useStepsToCome<T extends Kept>(loaded: LoadedSteps<T> | undefined): boolean {
  return useSession((s) => (watchedCore(s)?.step ?? 0) > 0) && loaded === undefined;
}
