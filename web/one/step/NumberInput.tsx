// A number: typed, or moved by a slider, with its everyday word.
import { useState } from "react";
import type { ExactJson } from "../../shared/edit/exact";
import { limitsText, readNumber, shownNumber, wordFor, type NumberField } from "../../shared/skills/form";
import { texts } from "../texts";

interface Props {
  readonly id: string;
  readonly label: string;
  readonly disabled: boolean;
  readonly field: NumberField;
  readonly value: number | undefined;
  readonly set: (value: ExactJson) => void;
}

export function NumberInput({ id, label, disabled, field, value, set }: Props) {
  const shown = value === undefined ? "" : shownNumber(field, value);
  const [draft, setDraft] = useState<string>();
  const text = draft ?? shown;
  const read = readNumber(field, text);
  const commit = () => {
    if (draft !== undefined && draft.trim() !== shown) {
      if ("problem" in read) return;
      set(read.value);
    }
    setDraft(undefined);
  };
  const number = Number(text.replace(",", ".")) / field.factor;
  const problem = draft !== undefined && "problem" in read ? read.problem : undefined;
  return (
    <div className="number">
      {field.kind === "slider" && (
        <input
          type="range"
          aria-label={texts.value.slider(label)}
          disabled={disabled}
          min={(field.min ?? 0) * field.factor}
          max={(field.max ?? 0) * field.factor}
          step={field.step * field.factor}
          value={Number.isFinite(number) ? number * field.factor : 0}
          aria-valuetext={field.words === undefined ? `${text} ${field.unit}` : `${wordFor(field.words, number)}, ${text} ${field.unit}`}
          onChange={(event) => setDraft(shownNumber(field, Number(event.target.value) / field.factor))}
          onPointerUp={commit}
          onKeyUp={commit}
          onBlur={commit}
        />
      )}
      <span className="number-entry">
        {field.kind === "number" && field.whole && <StepButton sign={-1} label={label} disabled={disabled} field={field} number={number} set={set} />}
        <input
          id={id}
          inputMode={field.whole ? "numeric" : "decimal"}
          autoComplete="off"
          disabled={disabled}
          value={text}
          aria-invalid={problem !== undefined}
          onChange={(event) => setDraft(event.target.value)}
          onBlur={commit}
          onKeyDown={(event) => {
            if (event.key === "Enter") commit();
            if (event.key === "Escape") setDraft(undefined);
          }}
        />
        {field.kind === "number" && field.whole && <StepButton sign={1} label={label} disabled={disabled} field={field} number={number} set={set} />}
        {field.unit !== "" && <span>{field.unit}</span>}
        {field.words !== undefined && Number.isFinite(number) && text !== "" && <b>{wordFor(field.words, number)}</b>}
      </span>
      {problem !== undefined && (
        <p className="problem" role="alert">
          {texts.value.wrong(problem === limitsText(field) ? problem : problem.replace(", please", ""))}
        </p>
      )}
    </div>
  );
}

interface StepProps {
  readonly sign: 1 | -1;
  readonly label: string;
  readonly disabled: boolean;
  readonly field: NumberField;
  /** What there is now. */
  readonly number: number;
  readonly set: (value: ExactJson) => void;
}

/** One more, or one less. */
function StepButton({ sign, label, disabled, field, number, set }: StepProps) {
  const next = readNumber(field, String(number + sign * field.step));
  return (
    <button type="button" aria-label={texts.value[sign === 1 ? "more" : "less"](label)} disabled={disabled || "problem" in next} onClick={() => "value" in next && set(next.value)}>
      {sign === 1 ? "+" : "−"}
    </button>
  );
}
