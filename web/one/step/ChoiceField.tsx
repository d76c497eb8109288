// One of several values; yes or no; a colour.
import type { ExactJson } from "../../shared/edit/exact";
import type { JsonValue } from "../../shared/json";
import type { SkillChoice } from "../../shared/skills/skill";
import { texts } from "../texts";

interface Common {
  readonly id: string;
  readonly label: string;
  readonly disabled: boolean;
}

interface ChoiceProps extends Common {
  readonly choices: readonly SkillChoice[];
  readonly value: JsonValue | undefined;
  readonly set: (value: JsonValue) => void;
}

export function ChoiceField({ id, disabled, choices, value, set }: ChoiceProps) {
  const chosen = choices.findIndex((choice) => JSON.stringify(choice.value) === JSON.stringify(value));
  return (
    <select
      id={id}
      disabled={disabled}
      value={chosen}
      onChange={(event) => {
        const choice = choices[Number(event.target.value)];
        if (choice !== undefined) set(choice.value);
      }}
    >
      {chosen === -1 && <option value={-1}>{value === undefined ? texts.value.choose : JSON.stringify(value)}</option>}
      {choices.map((choice, i) => (
        <option key={choice.title} value={i}>
          {choice.title}
        </option>
      ))}
    </select>
  );
}

interface ToggleProps extends Common {
  readonly value: boolean;
  readonly set: (value: ExactJson) => void;
}

export function ToggleField({ id, label, disabled, value, set }: ToggleProps) {
  return (
    <label className="toggle">
      <input id={id} type="checkbox" disabled={disabled} checked={value} onChange={(event) => set(event.target.checked)} />
      <span>{label}</span>
    </label>
  );
}

interface ColourProps extends Common {
  readonly value: string;
  readonly set: (value: ExactJson) => void;
}

export function ColourField({ id, disabled, value, set }: ColourProps) {
  return <input id={id} type="color" className="colour" disabled={disabled} value={value} onChange={(event) => set(event.target.value)} />;
}
