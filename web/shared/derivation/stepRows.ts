// The list of macro steps: what a filter leaves, with steps one after the other that changed nothing in one row.
import type { TraceStep } from "../../generated/messages";
import { callText, inputText } from "../run/inputText";

export type StepRow =
  | { readonly kind: "step"; readonly step: TraceStep }
  /** From `first` to `last`, so many; in none of them anything changed. */
  | { readonly kind: "idle"; readonly first: number; readonly last: number; readonly count: number };

/** So many are one row, not fewer. */
const kFold = 3;

const isIdle = (step: TraceStep): boolean => step.micro.length === 0 && step.calls.length === 0 && step.complete !== false && (step.first ?? 0) === 0;

const matches = (step: TraceStep, wanted: string): boolean => [inputText(step.input), ...step.calls.map(callText), String(step.step)].some((text) => text.toLowerCase().includes(wanted));

/** `shown`: the macro step whose derivation is shown, and `opened`: first steps of rows that somebody has opened: they are told one by one. */
export function stepRows(steps: readonly TraceStep[], filter: string, shown: number | undefined, opened: ReadonlySet<number>): readonly StepRow[] {
  const wanted = filter.trim().toLowerCase();
  if (wanted !== "") return steps.filter((step) => matches(step, wanted)).map((step) => ({ kind: "step", step }));
  const rows: StepRow[] = [];
  for (let i = 0; i < steps.length; ) {
    let end = i;
    for (let step = steps[end]; step !== undefined && isIdle(step); step = steps[end]) ++end;
    const idle = steps.slice(i, end);
    const [first, last] = [idle[0], idle.at(-1)];
    const folds = idle.length >= kFold && first !== undefined && last !== undefined && !opened.has(first.step) && !idle.some(({ step }) => step === shown);
    if (folds) rows.push({ kind: "idle", first: first.step, last: last.step, count: idle.length });
    else rows.push(...steps.slice(i, Math.max(end, i + 1)).map((step): StepRow => ({ kind: "step", step })));
    i = Math.max(end, i + 1);
  }
  return rows;
}
