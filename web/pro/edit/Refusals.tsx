// What could not be done, with the reason, until the user closes it; what was done, for a moment. It does not take the focus.
import { useEffect } from "react";
import type { Told } from "../../shared/edit/editing";
import { editing, useEditing } from "./editing";

/** How long it is shown that something was done [ms]. */
const kMoment = 3000;

const close = (number: number) => editing.dispatch({ type: "seen", number });

export function Refusals() {
  const told = useEditing((now) => now.told);
  if (told.length === 0) return null;
  return (
    <ul className="refusals" role="log" aria-label="Refused edits">
      {told.map((each) => (
        <Line key={each.number} told={each} />
      ))}
    </ul>
  );
}

function Line({ told: { number, text, tone } }: { readonly told: Told }) {
  useEffect(() => {
    if (tone !== "done") return;
    const timer = setTimeout(() => close(number), kMoment);
    return () => clearTimeout(timer);
  }, [number, tone]);
  return (
    <li className={`is-${tone}`}>
      <span>{text}</span>
      <button type="button" aria-label="Close" onClick={() => close(number)}>
        ✕
      </button>
    </li>
  );
}
