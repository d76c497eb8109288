// One of several: what the arrow keys pass is not chosen before Enter, or before the field is left; Esc goes back. A click chooses at once.
import { useId, useRef, useState, type KeyboardEvent } from "react";
import { useRefusal } from "../../login/rights";

export interface Choice {
  readonly value: string;
  readonly text: string;
}

interface Props {
  readonly label: string;
  readonly value: string;
  readonly choices: readonly Choice[];
  readonly onChoose: (value: string) => void;
  readonly isBare?: boolean;
  readonly place?: string;
  readonly className?: string;
}

/** Keys by which a closed list goes on to another choice. */
const isStepping = ({ key, altKey }: KeyboardEvent): boolean => !altKey && (key.startsWith("Arrow") || key.startsWith("Page") || key === "Home" || key === "End" || (key.length === 1 && key !== " "));

export function ChoiceField({ label, value, choices, onChoose, isBare = false, place, className }: Props) {
  const unique = useId();
  const [held, setHeld] = useState<string>();
  const refusal = useRefusal("edit");
  const stepping = useRef(false);
  const choose = (chosen: string | undefined) => {
    setHeld(undefined);
    if (chosen !== undefined && chosen !== value) onChoose(chosen);
  };
  const press = (event: KeyboardEvent) => {
    stepping.current = isStepping(event);
    if (event.key === "Enter" && held !== undefined) {
      event.preventDefault();
      choose(held);
    } else if (event.key === "Escape" && held !== undefined) {
      setHeld(undefined);
      event.stopPropagation();
    }
  };
  const known = choices.some((choice) => choice.value === value);
  return (
    <div className={["form-field is-choice", held !== undefined && "is-draft", isBare && "is-bare", className].filter(Boolean).join(" ")}>
      {!isBare && <label htmlFor={unique}>{label}</label>}
      <select
        id={unique}
        aria-label={isBare ? label : undefined}
        data-place={place}
        value={held ?? value}
        disabled={refusal !== undefined}
        title={refusal}
        onPointerDown={() => (stepping.current = false)}
        onKeyDown={press}
        onChange={(event) => (stepping.current ? setHeld(event.target.value) : choose(event.target.value))}
        onBlur={() => choose(held)}
      >
        {!known && <option value={value}>{value} (not there)</option>}
        {choices.map((choice) => (
          <option key={choice.value} value={choice.value}>
            {choice.text}
          </option>
        ))}
      </select>
      {held !== undefined && <small className="field-hint">Enter takes it, Esc goes back</small>}
    </div>
  );
}
