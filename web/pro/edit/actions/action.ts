// Actions: what can be done on the page that edits, each once, for keys, command palette, context menu and help.
import { refusalOfActionNow } from "../../login/rights";
import type { MenuEntry } from "../prompt";
import { refuse } from "../say";
import { situationNow, type Situation } from "../situation";

export type ActionGroup = "Document" | "Edit" | "Add" | "Connect" | "Structure" | "Place" | "Library" | "Walk" | "Debug" | "Page";

export interface Action {
  readonly id: string;
  readonly name: string;
  /** As shared/session/shortcuts.ts writes them; the first is shown. */
  readonly keys: readonly string[];
  readonly group: ActionGroup;
  /** Where its keys act: with the focus in the drawing or the tree; anywhere but where one types; anywhere. `page`: the page itself takes them. */
  readonly where: "model" | "untyped" | "anywhere" | "page";
  /** Whether a key that is held does it again and again. */
  readonly repeats?: true;
  /** Why it cannot be done now; nothing: it can. */
  readonly when: (situation: Situation) => string | undefined;
  readonly run: (situation: Situation) => void;
}

/** Why it cannot be done now. */
export const reasonAgainst = (action: Action, situation: Situation | undefined): string | undefined =>
  refusalOfActionNow(action) ?? (situation === undefined ? "no document is here" : action.when(situation));

/** Does it, or tells why not. */
export function runAction(action: Action): void {
  const situation = situationNow();
  const reason = reasonAgainst(action, situation);
  if (reason !== undefined) refuse(reason);
  else if (situation !== undefined) action.run(situation);
}

/** The action as an entry of a menu. */
export const menuEntry = (action: Action, situation: Situation): MenuEntry => ({
  name: action.name,
  ...(action.keys[0] !== undefined && { keys: action.keys[0] }),
  reason: reasonAgainst(action, situation),
  run: () => runAction(action),
});
