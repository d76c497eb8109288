// The inputs that have come and are not delivered, of the present or of a moment of the past.
import type { ReactNode } from "react";
import type { Past } from "../../generated/messages";
import { inputText } from "../../shared/run/inputText";

interface Props {
  /** Nothing: it is not known. */
  readonly waiting: Past["waiting"];
  /** What is said then. */
  readonly unknown: string;
  readonly none: string;
  /** Of an input: `step` has delivered it; it is the n-th of those that wait, from 0. */
  readonly about: (step: number | undefined, at: number) => ReactNode;
}

export function InputList({ waiting, unknown, none, about }: Props) {
  return (
    <section aria-label="Inputs waiting">
      <h3>Inputs waiting</h3>
      {waiting === undefined && <p className="quiet">{unknown}</p>}
      {waiting?.count === 0 && <p className="quiet">{none}</p>}
      <ul className="past-list">
        {waiting?.inputs.map(({ input, step }, i) => (
          <li key={i}>
            <code>{inputText(input)}</code>
            <small>{about(step, i)}</small>
          </li>
        ))}
      </ul>
      {waiting !== undefined && waiting.count > waiting.inputs.length && <p className="quiet">and {waiting.count - waiting.inputs.length} more</p>}
    </section>
  );
}
