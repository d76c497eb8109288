// Several texts: known ones are switched on and off, others are typed.
import { useState } from "react";
import type { ExactJson } from "../../shared/edit/exact";
import { texts } from "../texts";

interface Props {
  readonly id: string;
  readonly label: string;
  readonly disabled: boolean;
  readonly known: readonly string[];
  readonly values: readonly string[];
  readonly set: (value: ExactJson) => void;
}

export function TextsField({ id, label, disabled, known, values, set }: Props) {
  const [typed, setTyped] = useState("");
  const all = [...values, ...known.filter((text) => !values.includes(text))].sort((a, b) => a.localeCompare(b));
  const add = () => {
    const text = typed.trim();
    setTyped("");
    if (text !== "" && !values.includes(text)) set([...values, text]);
  };
  return (
    <div className="texts" role="group" aria-label={label}>
      <div className="chips">
        {all.map((text) => (
          <label key={text} className="chip">
            <input type="checkbox" disabled={disabled} checked={values.includes(text)} onChange={(event) => set(event.target.checked ? [...values, text] : values.filter((each) => each !== text))} />
            <span>{text}</span>
          </label>
        ))}
      </div>
      <span className="add-text">
        <input id={id} disabled={disabled} placeholder={texts.value.another} maxLength={80} value={typed} onChange={(event) => setTyped(event.target.value)} onKeyDown={(event) => event.key === "Enter" && add()} />
        <button type="button" disabled={disabled || typed.trim() === ""} onClick={add}>
          {texts.value.add}
        </button>
      </span>
    </div>
  );
}
