// One of the lists of a state, as rows.
import type { ReactNode } from "react";
import { addRow, moveRow, removeRow, type RowList } from "../../../shared/edit/commands/rows";
import { nameOfElement } from "../../../shared/edit/commands/command";
import type { Conflicts } from "../../../shared/edit/order";
import { listOf } from "../../../shared/edit/tree";
import { newId } from "../../../shared/newId";
import { editedDocument, perform, useEditing } from "../editing";
import { Rows } from "./Rows";

const kNone: readonly string[] = [];

interface Props {
  readonly state: string;
  readonly list: RowList;
  readonly label: string;
  readonly one: string;
  readonly numbered?: Conflicts;
  readonly row: (id: string) => ReactNode;
}

/** Moves an element within its list. */
export function moveTo(id: string, to: number): void {
  const tree = editedDocument();
  const change = tree && moveRow(tree, id, to);
  if (change !== undefined) perform(change);
}

export function ElementRows({ state, list, label, one, numbered, row }: Props) {
  const tree = useEditing(({ session }) => session?.view);
  const ids = tree === undefined ? kNone : listOf(tree, state, list);
  const add = (after: string | undefined) => {
    const now = editedDocument();
    if (now === undefined) return undefined;
    const made = addRow(now, state, list, after, newId);
    if ("change" in made) perform(made.change);
    return made.select;
  };
  const items = ids.map((id, i) => ({ id, name: tree === undefined || list === "actions" ? String(i + 1) : nameOfElement(tree, id), content: row(id) }));
  return (
    <Rows label={label} one={one} items={items} {...(numbered !== undefined && { numbered })} className={`is-${list}`} onAdd={add} onRemove={(id) => perform(removeRow(id))} onMove={moveTo} />
  );
}
