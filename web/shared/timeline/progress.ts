// Where a run is in the time lines of its application: which steps are active, by the ids of their states, and what went wrong.
import type { ModelTree } from "../model/modelTree";
import { splitAddress } from "../model/modelTree";
import type { Step, TimeLine } from "./timeLine";

/** The ids of the states that are active. */
export function activeIds(active: readonly string[], model: ModelTree): ReadonlySet<string> {
  return new Set(active.flatMap((path) => model.get(path)?.node.id ?? []));
}

/** What happens now, and what is next. */
export interface Progress {
  /** The steps that are active, the innermost of each time line, with the task first. */
  readonly now: readonly Step[];
  readonly next: Step | undefined;
  /** Of the time line of the innermost active step: how many of its steps that are on stand before it. */
  readonly done: number;
  readonly line: TimeLine | undefined;
  /** The innermost of them has failed, and that is being handled. */
  readonly failing: boolean;
}

export const kNoProgress: Progress = { now: [], next: undefined, done: 0, line: undefined, failing: false };

/** Of what stands in a time line; the first that is active, if there are several. */
export function progressIn(line: TimeLine, active: ReadonlySet<string>): Progress {
  const on = line.steps.filter(({ disabled }) => !disabled);
  const all = [...on, ...line.others];
  const step = all.find(({ id }) => active.has(id)) ?? all.find(({ handlers }) => handlers.some((id) => active.has(id)));
  if (step === undefined) return kNoProgress;
  const at = on.indexOf(step);
  const next = at === -1 ? undefined : on[at + 1];
  const within = step.inner === undefined ? kNoProgress : progressIn(step.inner, active);
  if (within.now.length > 0) return { ...within, now: [step, ...within.now], next: within.next ?? next };
  return { now: [step], next, done: Math.max(0, at), line, failing: !active.has(step.id) };
}

/** An error of a step that has fired. */
export interface Failed {
  readonly step: Step;
  /** By its name. */
  readonly port: string;
  readonly title: string;
  readonly advice: string;
}

/** The first of these ports that is an error of a step; `ports`: addresses in the model of the run. */
export function failedIn(ports: readonly string[], model: ModelTree, steps: readonly Step[]): Failed | undefined {
  for (const address of ports) {
    const parts = splitAddress(address);
    const id = parts === undefined ? undefined : model.get(parts.path)?.node.id;
    const step = steps.find((each) => each.id === id && (each.inner === undefined || each.kind === "skill"));
    const port = step?.errors.find(({ name }) => name === parts?.port);
    if (step !== undefined && port !== undefined) return { step, port: port.name, title: port.title, advice: port.advice ?? "" };
  }
  return undefined;
}
