// What was forced in the watched run: of the past by its journal, since then by its deltas.
import type { CoreDelta, Input, Journal } from "../../generated/messages";

export interface Forced {
  /** The macro step. */
  readonly step: number;
  readonly input: Input;
}

/** More are not kept, nor read. */
const kMost = 500;

/** With what a delta says: a macro step may come in several. */
export function withForced(known: readonly Forced[], { core: { step }, input }: Pick<CoreDelta, "core" | "input">): readonly Forced[] {
  return input?.kind !== "force" || known.at(-1)?.step === step ? known : [...known, { step, input }].slice(-kMost);
}

/** What was forced until the journal was read. */
export const forcedInJournal = ({ entries }: Journal): readonly Forced[] =>
  entries.flatMap(({ position, input }) => (input.kind === "force" ? [{ step: position, input }] : [])).slice(-kMost);

/** Both in order, each step once. */
export const allForced = (past: readonly Forced[], since: readonly Forced[]): readonly Forced[] =>
  [...new Map([...past, ...since].map((each) => [each.step, each])).values()].sort((a, b) => a.step - b.step).slice(-kMost);
