// What can be done about a field that somebody else has set, too: at the field, and in the list above the drawing.
import { choicesOf, type Conflict } from "../../shared/edit/conflicts";
import type { Change } from "../../shared/edit/session";
import { settle, settleBy, useConflictAt } from "./conflicts";
import { useEditing } from "./editing";

interface Props {
  readonly number: number;
  readonly conflict: Conflict;
}

export function ConflictChoices({ number, conflict }: Props) {
  const tree = useEditing(({ session }) => session?.view);
  if (tree === undefined) return null;
  const { holds, mine, theirs } = choicesOf(conflict, tree);
  return (
    <span className="field-choices">
      <Choice name={holds === "mine" ? "Keep mine" : "Take mine"} change={mine} holds={holds === "mine"} number={number} />
      <Choice name={holds === "theirs" ? "Keep theirs" : "Take theirs"} change={theirs} holds={holds === "theirs"} number={number} />
    </span>
  );
}

/** Keeping what holds is no edit. */
function Choice({ name, change, holds, number }: { readonly name: string; readonly change: Change | undefined; readonly holds: boolean; readonly number: number }) {
  if (!holds && change === undefined) return null;
  return (
    <button type="button" onClick={() => (change === undefined ? settle(number) : settleBy(number, change))}>
      {name}
    </button>
  );
}

/** At the field. */
export function ConflictNote({ id, field }: { readonly id: string; readonly field: string }) {
  const told = useConflictAt(id, field);
  if (told?.conflict === undefined) return null;
  return (
    <div className="field-theirs" role="group" aria-label="Set by somebody else, too">
      <span>{told.text}</span>
      <ConflictChoices number={told.number} conflict={told.conflict} />
    </div>
  );
}
