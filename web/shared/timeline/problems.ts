// Why an application cannot be started yet, step by step and in words.
import type { Tree } from "../edit/tree";
import { missingServices, serviceText, type ServiceHere } from "../skills/closure";
import { linkedState } from "../skills/declared";
import { isDisabled } from "./plan";
import { allSteps, type Step, type TimeLine } from "./timeLine";

export interface StepProblem {
  readonly step: string;
  readonly text: string;
  /** The parameter to be set. */
  readonly parameter?: string;
}

function problemsOfStep(tree: Tree, step: Step, here: readonly ServiceHere[]): readonly StepProblem[] {
  if (step.kind !== "skill") return [];
  const linked = linkedState(tree, step.id);
  const missing = linked === undefined ? [] : missingServices(tree, linked, here);
  const services = missing.map((key) => ({ step: step.id, text: `${serviceText(key)} is not there` }));
  const values = step.parameters.flatMap(({ about, value }): readonly StepProblem[] => {
    if (value.kind === "missing") return [{ step: step.id, parameter: about.name, text: about.domain === "found" ? "no step before it finds a part" : `"${about.title}" is not set` }];
    if (value.kind === "taken" && isDisabled(tree, value.source.step)) return [{ step: step.id, parameter: about.name, text: "the step that finds its part is off" }];
    return [];
  });
  return [...services, ...values];
}

/** Steps that are on, with those within. */
const on = (line: TimeLine): readonly Step[] => [...line.steps, ...line.others].flatMap((step) => (step.disabled ? [] : [step, ...(step.inner === undefined ? [] : on(step.inner))]));

/** Of steps that are on. */
export const problemsOf = (tree: Tree, root: TimeLine, here: readonly ServiceHere[]): readonly StepProblem[] => on(root).flatMap((step) => problemsOfStep(tree, step, here));

/** A step needs a pose that nobody has taught, and no step before it teaches. It can be started all the same. */
export interface Untaught {
  readonly step: string;
  readonly parameter: string;
  /** Its name. */
  readonly pose: string;
}

/** Of steps that are on, in their order. `taught`: the names of all poses. */
export function untaughtPoses(root: TimeLine, taught: readonly string[]): readonly Untaught[] {
  const known = new Set(taught);
  const found: Untaught[] = [];
  for (const { id, parameters } of on(root))
    for (const { about, value } of parameters) {
      if (about.domain !== "pose" || value.kind !== "constant" || typeof value.value !== "string" || known.has(value.value)) continue;
      if (about.teaches) known.add(value.value);
      else found.push({ step: id, parameter: about.name, pose: value.value });
    }
  return found;
}

export const stepById = (root: TimeLine, id: string): Step | undefined => allSteps(root).find((step) => step.id === id);
