// What the page shows of a run: as it was, while it looks at a moment of the past, else as it is.
import type { Fault, Past, TraceStep } from "../../generated/messages";
import { stepsBefore } from "../derivation/proof";
import type { RcmDocument } from "../model/model";
import { isBadOutcome } from "../run/controls";
import { noneFired, type Fired } from "../run/fired";
import { liveState, type LiveState } from "../run/liveState";
import { watchedCore, type Session } from "../session/session";

/** A moment of the past that the page looks at. */
export interface ShownPast {
  readonly past: Past;
  /** The derivations around it, as far as they are here. */
  readonly steps: readonly TraceStep[];
  /** What the run executed then, if it is not what it executes now. */
  readonly model: RcmDocument | undefined;
  /** Why the model that is drawn may be another than that of the moment. */
  readonly doubt: string | undefined;
}

export const stateShown = ({ past, run }: Session): LiveState | undefined => (past === undefined ? run : liveState(past.past.state));

export const modelShown = ({ past, model }: Session): RcmDocument | undefined => past?.model ?? model;

export const faultShown = (session: Session): Fault | undefined => (session.past === undefined ? watchedCore(session)?.fault : session.past.past.fault);

/** The port of the root through which the run ended badly (isBadOutcome), as its address. */
export function badEndShown(session: Session): string | undefined {
  const { outcome } = (session.past === undefined ? watchedCore(session) : session.past.past) ?? {};
  const root = modelShown(session)?.root.name;
  return root === undefined || !isBadOutcome(outcome) ? undefined : `${root}.${outcome}`;
}

/** Which ports have just fired is only known of the present. */
export const firedShown = ({ past, fired }: Session): Fired => (past === undefined ? fired : noneFired);

/** The derivations that are listed: those around the moment, if it is older than the others. */
export function stepsShown({ past, steps }: Session): readonly TraceStep[] {
  return past === undefined || steps.some(({ step }) => step === past.past.step) ? steps : past.steps;
}

const untilMoment = new WeakMap<ShownPast, { readonly of: readonly TraceStep[]; readonly steps: readonly TraceStep[] }>();

/** The derivations of what had happened at the moment; the same object while neither changes. */
export function stepsUntil(session: Session): readonly TraceStep[] {
  const { past } = session;
  const of = stepsShown(session);
  if (past === undefined) return of;
  const known = untilMoment.get(past);
  if (known?.of === of) return known.steps;
  const steps = stepsBefore(of, past.past);
  untilMoment.set(past, { of, steps });
  return steps;
}
