// The form in which a pose is saved: its name, and what has become of the last save until somebody writes another name. The words are those of the page.
import { freeName, isPoseName } from "./poses";

export interface Saving {
  /** What a person has written; nothing: the name that is proposed. */
  readonly entry: string | undefined;
  readonly last: SaveOutcome | undefined;
}

export type SaveOutcome = { readonly type: "saved"; readonly name: string } | { readonly type: "not_saved"; readonly why: string };

export type SavingEvent = { readonly type: "written"; readonly entry: string } | SaveOutcome;

export const kFirstSaving: Saving = { entry: undefined, last: undefined };

export function applySaving(saving: Saving, event: SavingEvent): Saving {
  switch (event.type) {
    case "written":
      return { entry: event.entry, last: undefined };
    case "saved":
      return { entry: undefined, last: event };
    case "not_saved":
      return { ...saving, last: event };
  }
}

export interface SavingNames {
  /** Of all poses. */
  readonly names: readonly string[];
  /** What names that are proposed begin with. */
  readonly stem?: string | undefined;
  /** The one name under which it is saved. */
  readonly fixed?: string | undefined;
  /** Whether a person may write the name. */
  readonly isNamed: boolean;
}

export interface ShownSaving {
  readonly name: string;
  readonly isName: boolean;
  readonly isTaken: boolean;
  /** What the button does: saves under the one name there is, under the one that is proposed, in place of a pose, or as a new one. */
  readonly button: "fixed" | "proposed" | "replace" | "save";
  /** Nothing: there is nothing to be said. */
  readonly hint: SaveOutcome | { readonly type: "no_name" | "taken" } | undefined;
  readonly isBad: boolean;
}

export function shownSaving({ entry, last }: Saving, { names, stem, fixed, isNamed }: SavingNames): ShownSaving {
  const name = fixed ?? entry ?? freeName(names, stem);
  const [isName, isTaken] = [isPoseName(name), names.includes(name)];
  const button = fixed !== undefined ? "fixed" : !isNamed ? "proposed" : isTaken ? "replace" : "save";
  const hint = !isName ? ({ type: "no_name" } as const) : (last ?? (isTaken ? ({ type: "taken" } as const) : undefined));
  return { name, isName, isTaken, button, hint, isBad: hint?.type === "no_name" || hint?.type === "not_saved" };
}
