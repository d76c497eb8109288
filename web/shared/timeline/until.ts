// Until when a loop repeats: what its steps can say, and which of that ends it.
import type { Step, TimeLine } from "./timeLine";

/** An outcome of a step that is repeated. */
export interface End {
  readonly step: Step;
  readonly port: string;
  /** What has happened then, for people. */
  readonly title: string;
  /** It ends the loop. */
  readonly isChosen: boolean;
}

const on = (line: TimeLine | undefined): readonly Step[] => (line?.form === "editable" ? line.steps.filter(({ disabled }) => !disabled) : []);

/** What can end a loop besides counting: the outcomes of the steps that it repeats itself, not of those in tasks or loops within. */
export const endsOf = ({ inner }: Step): readonly End[] => on(inner).flatMap((step) => step.outcomes.map(({ port: { name, title }, goes }) => ({ step, port: name, title, isChosen: goes === "leave" })));

/** The steps that end a loop by an error of theirs. */
export const failuresThatEnd = ({ inner }: Step): readonly Step[] => on(inner).filter(({ failure }) => failure?.kind === "leave" || (failure?.kind === "retry" && failure.then === "leave"));
