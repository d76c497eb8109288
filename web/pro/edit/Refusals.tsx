// Edits that were refused, with the reason, until the user closes them. They do not take the focus.
import { refusalText } from "../../shared/edit/refusalText";
import { editing, useEditing } from "./editing";

export function Refusals() {
  const told = useEditing((now) => now.told);
  if (told.length === 0) return null;
  return (
    <ul className="refusals" role="log" aria-label="Refused edits">
      {told.map(({ number, notice }) => (
        <li key={number}>
          <span>{refusalText(notice)}</span>
          <button type="button" aria-label="Close" onClick={() => editing.dispatch({ type: "seen", number })}>
            ✕
          </button>
        </li>
      ))}
    </ul>
  );
}
