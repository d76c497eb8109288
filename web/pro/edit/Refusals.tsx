// What could not be done, with the reason, and what others did to what was written here, until the user closes it; what was done, for a moment. It
// does not take the focus.
import { useEffect } from "react";
import { changeText, withNames, writtenText } from "../../shared/edit/changeText";
import type { Told } from "../../shared/edit/editing";
import type { Notice } from "../../shared/edit/session";
import { ConflictChoices } from "./ConflictChoices";
import { settle, settleBy } from "./conflicts";
import { copyWritten } from "./copyWritten";
import { useEditing } from "./editing";

/** How long it is shown that something was done [ms]. */
const kMoment = 3000;

export function Refusals() {
  const told = useEditing((now) => now.told);
  if (told.length === 0) return null;
  return (
    <div className="refusals" role="log" aria-label="Refused edits">
      <ul>
        {told.map((each) => (
          <Line key={each.number} told={each} />
        ))}
      </ul>
    </div>
  );
}

function Line({ told: { number, text, tone, notice, conflict } }: { readonly told: Told }) {
  useEffect(() => {
    if (tone !== "done") return;
    const timer = setTimeout(() => settle(number), kMoment);
    return () => clearTimeout(timer);
  }, [number, tone]);
  return (
    <li className={`is-${tone}`}>
      <span>
        <Named text={text} />
        {notice !== undefined && <Refused notice={notice} />}
      </span>
      {notice !== undefined && <RefusedChoices number={number} notice={notice} />}
      {conflict !== undefined && <ConflictChoices number={number} conflict={conflict} />}
      <button type="button" aria-label="Close" onClick={() => settle(number)}>
        ✕
      </button>
    </li>
  );
}

function Named({ text }: { readonly text: string }) {
  return useEditing(({ session }) => (session?.view === undefined ? text : withNames(session.view, text)));
}

/** What it was. */
function Refused({ notice: { change } }: { readonly notice: Notice }) {
  const text = useEditing(({ session }) => session?.view && changeText(session.view, change));
  return text === undefined ? null : <small> {text}</small>;
}

/** What it would have written is not lost, and it can be tried on the document as it is now. */
function RefusedChoices({ number, notice: { change } }: { readonly number: number; readonly notice: Notice }) {
  const written = writtenText(change);
  // Another undo takes back another edit.
  const isRepeatable = "operations" in change || "compound" in change;
  return (
    <span className="field-choices">
      {isRepeatable && (
        <button type="button" onClick={() => settleBy(number, change)}>
          Try again
        </button>
      )}
      {written !== undefined && (
        <button type="button" title="Copy what it would have written" onClick={() => copyWritten(written)}>
          Copy
        </button>
      )}
    </span>
  );
}
