// One argument of a run: its field by its type, what it expects, and what is wrong with what was typed.
import { useId } from "react";
import { expectation, firstText, inputOf } from "../../shared/arguments/entry";
import type { RunParameter } from "../../shared/arguments/parameters";

interface Props {
  readonly parameter: RunParameter;
  /** Nothing: as it was at first. */
  readonly text: string | undefined;
  readonly problem: string | undefined;
  readonly onChange: (text: string) => void;
}

export function ArgumentField({ parameter, text, problem, onChange }: Props) {
  const id = useId();
  const [hint, wrong] = [`${id}-hint`, `${id}-problem`];
  const { name, unit, doc, initial, type } = parameter;
  const input = inputOf(type);
  const first = firstText(parameter);
  const field = {
    id, name, value: text ?? first, "aria-describedby": problem === undefined ? hint : `${wrong} ${hint}`, "aria-invalid": problem !== undefined, "aria-required": initial === undefined,
    onChange: (event: { readonly target: { readonly value: string } }) => onChange(event.target.value),
  };
  const typed = { ...field, spellCheck: false, autoComplete: "off" };
  return (
    <div className="argument">
      <label htmlFor={id}>
        {name}
        {initial === undefined && <span aria-hidden="true"> *</span>}
      </label>
      <div className="argument-value">
        {input.kind === "choice" && (
          <select {...field}>
            {(input.choices.includes(first) ? input.choices : [first, ...input.choices]).map((choice) => (
              <option key={choice} value={choice}>
                {choice === "" ? "choose" : choice}
              </option>
            ))}
          </select>
        )}
        {input.kind === "json" && <textarea {...typed} rows={2} />}
        {(input.kind === "text" || input.kind === "number") && <input {...typed} type="text" inputMode={input.kind === "number" ? "decimal" : "text"} />}
        {unit !== undefined && <span className="argument-unit">{unit}</span>}
      </div>
      {problem !== undefined && (
        <p id={wrong} className="argument-problem">
          {name} {problem}
        </p>
      )}
      <p id={hint} className="argument-hint">
        {doc !== undefined && <span>{doc} </span>}
        {input.kind === "json" ? `JSON: ${expectation(parameter)}` : expectation(parameter)}
        {initial === undefined && ", required"}
      </p>
    </div>
  );
}
