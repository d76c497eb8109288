// At which parameter a pose is being taught, and at which the arm is looked at: at one at a time, as there is one arm and one view of it.
import { createStore, useSelected } from "../../page/store";
import { go } from "../place";
import { select } from "../select";

/** A parameter that is a pose. */
export interface PosePlace {
  /** Id of the step. */
  readonly step: string;
  readonly parameter: string;
}

interface Open {
  readonly taught: PosePlace | undefined;
  readonly shown: PosePlace | undefined;
}

const store = createStore<Open, Partial<Open>>({ taught: undefined, shown: undefined }, (now, change) => ({ ...now, ...change }));
const isAt = (place: PosePlace | undefined, step: string, parameter: string): boolean => place?.step === step && place.parameter === parameter;

/** Whether this is open at a parameter. */
export const useIsOpenAt = (what: keyof Open, step: string, parameter: string): boolean => useSelected(store, (open) => isAt(open[what], step, parameter));

/** `at`: nowhere, if it is nothing. */
export const openAt = (what: keyof Open, at: PosePlace | undefined): void => store.dispatch({ [what]: at });

/** The parameter is not shown any more. */
export function closeAt(step: string, parameter: string): void {
  for (const what of ["taught", "shown"] as const) if (isAt(store.get()[what], step, parameter)) openAt(what, undefined);
}

/** Leads to the parameter, from any view, and opens the buttons that move the arm. */
export function goToTeach({ step, parameter }: PosePlace): void {
  go({ view: "build", guide: undefined, part: undefined, goal: undefined });
  select(step);
  openAt("taught", { step, parameter });
}
