// What the components show of the document: its application, and what is selected.
import { useMemo } from "react";
import { readApplication, type Application } from "../shared/timeline/read";
import { problemsOf, untaughtPoses, type StepProblem, type Untaught } from "../shared/timeline/problems";
import { allSteps, type Step, type TimeLine } from "../shared/timeline/timeLine";
import { useSession } from "./client";
import { useTree } from "./editing";
import { usePlace } from "./place";
import { useTaughtPoses } from "./poses";

export function useApplication(): Application | undefined {
  const tree = useTree();
  return useMemo(() => tree && readApplication(tree), [tree]);
}

const kNone: readonly StepProblem[] = [];

/** What keeps the application from being started. */
export function useProblems(): readonly StepProblem[] {
  const tree = useTree();
  const services = useSession((s) => s.services);
  return useMemo(() => (tree === undefined || services.length === 0 ? kNone : problemsOf(tree, readApplication(tree).root, services)), [tree, services]);
}

const kAllTaught: readonly Untaught[] = [];

/** The poses that steps name and nobody has taught; none as long as it is not known which those are. */
export function useUntaught(): readonly Untaught[] {
  const application = useApplication();
  const { names, isLoaded, problem } = useTaughtPoses();
  return useMemo(() => (application === undefined || !isLoaded || problem !== undefined ? kAllTaught : untaughtPoses(application.root, names)), [application, names, isLoaded, problem]);
}

/** A step, and the time line in which it stands. */
export interface Found {
  readonly step: Step;
  readonly line: TimeLine;
}

export function findStep(line: TimeLine, id: string): Found | undefined {
  for (const step of [...line.steps, ...line.others]) {
    if (step.id === id) return { step, line };
    const within = step.inner && findStep(step.inner, id);
    if (within !== undefined) return within;
  }
  return undefined;
}

/** What the application has as time lines: that of the root, or the root as the one task. */
export const everyStep = (application: Application): readonly Step[] => [...application.tasks, ...application.tasks.flatMap((task) => (task.inner === undefined ? [] : allSteps(task.inner)))];

/** What is selected: a step, or a task. */
export function useSelected(): (Found & { readonly isTask: boolean }) | undefined {
  const application = useApplication();
  const [step, task] = [usePlace((place) => place.step), usePlace((place) => place.task)];
  return useMemo(() => {
    if (application === undefined) return undefined;
    const of = (id: string): Found | undefined => {
      const found = findStep(application.root, id);
      const own = application.tasks.find((each) => each.id === id);
      return found ?? (own === undefined ? undefined : { step: own, line: application.root });
    };
    const found = (step === undefined ? undefined : of(step)) ?? (task === undefined ? undefined : of(task));
    return found && { ...found, isTask: application.tasks.some(({ id }) => id === found.step.id) };
  }, [application, step, task]);
}

/** The task in which a step stands. */
export function taskOf(application: Application, id: string): Step | undefined {
  return application.tasks.find((task) => task.id === id || (task.inner !== undefined && findStep(task.inner, id) !== undefined));
}
