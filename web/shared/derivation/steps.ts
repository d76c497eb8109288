// The derivations of a run, one record for each macro step. The server sends a macro step within which the core was paused, or that is long, in parts.
import type { TraceStep } from "../../generated/messages";

const kKept = 200;

/** The micro steps that a record has: from `first`, up to before `end`. */
function rangeOf(step: TraceStep): { readonly first: number; readonly end: number } {
  const first = step.first ?? 0;
  return { first, end: first + step.micro.length };
}

/** Micro steps of the macro step, as far as it is known. */
export function microCount(step: TraceStep): number {
  return rangeOf(step).end;
}

const isComplete = (step: TraceStep): boolean => step.complete !== false;

/** One record of a macro step of two; of what is in both, `added` counts. If micro steps between them are missing, the later one. */
function join(known: TraceStep, added: TraceStep): TraceStep {
  const [old, young] = [rangeOf(known), rangeOf(added)];
  if (young.first === 0 && isComplete(added)) return added;
  if (young.first > old.end) return added;
  if (old.first > young.end) return known;
  const calls = added.calls.filter(({ call }) => call === undefined || known.calls.every((each) => each.call !== call));
  return {
    ...(old.end > young.end ? known : added),
    first: Math.min(old.first, young.first),
    micro: [...known.micro.slice(0, Math.max(0, young.first - old.first)), ...added.micro, ...known.micro.slice(Math.max(0, young.end - old.first))],
    calls: [...known.calls, ...calls],
    complete: (old.end >= young.end && isComplete(known)) || (young.end >= old.end && isComplete(added)),
  };
}

/** Adds steps to those that are known: parts of one macro step join, repeated steps replace, the oldest go. */
export function mergeSteps(known: readonly TraceStep[], added: readonly TraceStep[]): readonly TraceStep[] {
  const steps = new Map(known.map((step) => [step.step, step]));
  for (const step of added) {
    const before = steps.get(step.step);
    steps.set(step.step, before === undefined ? step : join(before, step));
  }
  return [...steps.values()].sort((a, b) => a.step - b.step).slice(-kKept);
}
