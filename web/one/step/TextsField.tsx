// Several texts: known ones are switched on and off, others are typed.
import { useState, type ReactNode } from "react";
import type { ExactJson } from "../../shared/edit/exact";
import { texts } from "../texts";
import { Chips } from "./Chips";

interface Props {
  readonly id: string;
  readonly label: string;
  readonly disabled: boolean;
  readonly known: readonly string[];
  /** Further known ones, which come first, in a frame of their own. */
  readonly apart?: { readonly texts: readonly string[]; readonly frame: (chips: ReactNode) => ReactNode };
  readonly values: readonly string[];
  readonly set: (value: ExactJson) => void;
}

export function TextsField({ id, label, disabled, known, apart, values, set }: Props) {
  const [typed, setTyped] = useState("");
  const unknown = values.filter((text) => !known.includes(text) && apart?.texts.includes(text) !== true).sort((a, b) => a.localeCompare(b));
  const add = () => {
    const text = typed.trim();
    setTyped("");
    if (text !== "" && !values.includes(text)) set([...values, text]);
  };
  const choice = { chosen: values, disabled, onChange: (text: string, isChosen: boolean) => set(isChosen ? [...values, text] : values.filter((each) => each !== text)) };
  return (
    <div className="texts" role="group" aria-label={label}>
      {apart?.frame(<Chips {...choice} texts={apart.texts} />)}
      <Chips {...choice} texts={[...known, ...unknown]} />
      <span className="add-text">
        <input id={id} disabled={disabled} placeholder={texts.value.another} maxLength={80} value={typed} onChange={(event) => setTyped(event.target.value)} onKeyDown={(event) => event.key === "Enter" && add()} />
        <button type="button" disabled={disabled || typed.trim() === ""} onClick={add}>
          {texts.value.add}
        </button>
      </span>
    </div>
  );
}
