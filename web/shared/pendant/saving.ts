// The form in which a pose is saved: its name, and what is said of the last save until somebody writes another name.
import { freeName, isPoseName } from "./poses";

export interface Saving {
  /** What a person has written; nothing: the name that is proposed. */
  readonly entry: string | undefined;
  readonly said: { readonly text: string; readonly isBad: boolean } | undefined;
}

export type SavingEvent =
  | { readonly type: "written"; readonly entry: string }
  | { readonly type: "saved"; readonly name: string }
  | { readonly type: "not_saved"; readonly why: string };

export const kFirstSaving: Saving = { entry: undefined, said: undefined };

export function applySaving(saving: Saving, event: SavingEvent): Saving {
  switch (event.type) {
    case "written":
      return { entry: event.entry, said: undefined };
    case "saved":
      return { entry: undefined, said: { text: `Saved as ${event.name}.`, isBad: false } };
    case "not_saved":
      return { ...saving, said: { text: `Not saved: ${event.why}. Try again.`, isBad: true } };
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
  /** Of the button. */
  readonly label: string;
  readonly hint: string;
  readonly isBad: boolean;
}

export function shownSaving({ entry, said }: Saving, { names, stem, fixed, isNamed }: SavingNames): ShownSaving {
  const name = fixed ?? entry ?? freeName(names, stem);
  const [isName, isTaken] = [isPoseName(name), names.includes(name)];
  const label = fixed !== undefined ? `Save “${fixed}” here` : !isNamed ? `Save as ${name}` : isTaken ? "Replace pose" : "Save pose";
  const taken = isTaken ? `${name} is there already: it will stand where the arm is now.` : "";
  return { name, isName, isTaken, label, hint: isName ? (said?.text ?? taken) : "A name has letters, digits, _ or -, at most 32.", isBad: !isName || said?.isBad === true };
}
