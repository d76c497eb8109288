// What is edited and not in the run: each row leads to its element; what was removed, to the state that it was in.
import { kSigns, type DifferenceRow } from "../../shared/edit/difference/rows";
import { placeOfRow } from "../../shared/live/marks";
import { view } from "../client";
import { selectById } from "../edit/forms/selectById";
import type { Compared } from "./executed";

/** So many are listed. */
const kMost = 200;

export function DifferenceList({ compared: { before, after, rows } }: { readonly compared: Compared }) {
  const go = (row: DifferenceRow) => {
    const id = placeOfRow(before, after, row);
    if (id === undefined) view.dispatch({ type: "select", selection: undefined });
    else selectById(id);
  };
  return (
    <ul aria-label="Changes that the run does not execute">
      {rows.slice(0, kMost).map((row) => (
        <li key={`${row.kind} ${row.id}`}>
          <button type="button" className={`difference is-${row.kind}`} onClick={() => go(row)}>
            <b aria-hidden="true">{kSigns[row.kind]}</b>
            <span>{row.kind}</span>
            <code>{row.name}</code>
            {row.text !== "" && <small>{row.text}</small>}
          </button>
        </li>
      ))}
      {rows.length > kMost && <li className="quiet">{rows.length - kMost} more</li>}
    </ul>
  );
}
