// A moment of a run, as the address of the page has it: `12.3` is macro step 12 after three of its micro steps.

export interface Moment {
  /** From 1. */
  readonly step: number;
  /** Micro steps of it that were done. */
  readonly micro: number;
}

/** A moment to ask for; without `micro`, the end of the macro step. */
export interface Wanted {
  readonly step: number;
  readonly micro?: number;
}

export const momentText = ({ step, micro }: Moment): string => `${step}.${micro}`;

/** When something is so: at a moment of the past that is shown, at the end of a run that is only stored, or now. */
export const whenText = (past: Moment | undefined, stored: boolean): string => (past !== undefined ? `at step ${momentText(past)}` : stored ? "at the end" : "now");

/** The moment that a text names: `12.3`, or `12` for the end of macro step 12; nothing if it names none. */
export function momentOf(text: string | undefined): Wanted | undefined {
  const [, step, micro] = /^([1-9]\d{0,8})(?:\.(\d{1,9}))?$/.exec(text ?? "") ?? [];
  if (step === undefined) return undefined;
  return micro === undefined ? { step: Number(step) } : { step: Number(step), micro: Number(micro) };
}

export const isSameMoment = (a: Moment, b: Moment): boolean => a.step === b.step && a.micro === b.micro;
