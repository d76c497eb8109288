// How two documents differ: each row leads to its element in the document that is edited; what that does not have, to the state around it.
import { kSigns, type DifferenceRow } from "../../shared/edit/difference/rows";
import { placeInShown } from "../../shared/live/marks";
import { view } from "../client";
import { editedDocument } from "../edit/editing";
import { selectById } from "../edit/forms/selectById";
import type { Compared } from "../../shared/edit/difference/compare";

/** So many are listed. */
const kMost = 200;

interface Props {
  readonly compared: Compared;
  /** Of the list. */
  readonly label: string;
}

/** What a row says. */
export function DifferenceText({ row }: { readonly row: DifferenceRow }) {
  return (
    <>
      <b aria-hidden="true">{kSigns[row.kind]}</b>
      <span>{row.kind}</span>
      <code>{row.name}</code>
      {row.text !== "" && <small>{row.text}</small>}
    </>
  );
}

export function DifferenceList({ compared: { before, after, rows }, label }: Props) {
  const go = (row: DifferenceRow) => {
    const id = placeInShown(before, after, editedDocument() ?? after, row);
    if (id === undefined) view.dispatch({ type: "select", selection: undefined });
    else selectById(id);
  };
  return (
    <ul aria-label={label}>
      {rows.slice(0, kMost).map((row) => (
        <li key={`${row.kind} ${row.id}`}>
          <button type="button" className={`difference is-${row.kind}`} onClick={() => go(row)}>
            <DifferenceText row={row} />
          </button>
        </li>
      ))}
      {rows.length > kMost && <li className="quiet">{rows.length - kMost} more</li>}
    </ul>
  );
}
