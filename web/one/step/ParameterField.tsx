// A parameter of a step: its name, how it is entered, and what it means.
import { useId } from "react";
import type { ExactJson } from "../../shared/edit/exact";
import type { JsonValue } from "../../shared/json";
import { exactNumber } from "../../shared/timeline/numbers";
import { fieldOf, valueText } from "../../shared/skills/form";
import { setSource, setValue, sourcesOf } from "../../shared/timeline/changes/values";
import type { StepParameter, TimeLine } from "../../shared/timeline/timeLine";
import { perform, useTree } from "../editing";
import { ChoiceField, ColourField, ToggleField } from "./ChoiceField";
import { NumberInput } from "./NumberInput";
import { PoseField } from "./PoseField";
import { TextField } from "./TextField";
import { LabelField, LabelsField } from "./LabelField";
import { TextsField } from "./TextsField";
import { texts } from "../texts";

const t = texts.value;

interface Props {
  /** The state that has the parameter. */
  readonly state: string;
  readonly line: TimeLine;
  readonly parameter: StepParameter;
  readonly problem: string | undefined;
  readonly disabled: boolean;
}

/** A choice as the document takes it: what is no int stays a float. */
const exactConstant = (value: JsonValue, type: JsonValue | undefined): ExactJson => (typeof value === "number" ? exactNumber(value, type !== "number") : value);

export function ParameterField({ state, line, parameter: { about, value }, problem, disabled }: Props) {
  const id = useId();
  const set = (next: ExactJson) => void perform((tree, supplies) => setValue(tree, state, about.name, next, supplies));
  const constant = value.kind === "constant" ? value.value : undefined;
  const field = fieldOf(about, constant);
  const common = { id, disabled, label: about.title };
  const items = Array.isArray(constant) ? constant.filter((item): item is string => typeof item === "string") : [];
  const isElsewhere = value.kind === "constant" && value.state !== state;
  const entry = () => {
    if (value.kind === "computed") return <output id={id} className="fixed">{t.computed(value.text)}</output>;
    switch (field.kind) {
      case "found":
        return <FoundField state={state} line={line} name={about.name} taken={value.kind === "taken" ? value.source.step : undefined} domain={about.domain} {...common} />;
      case "slider":
      case "number":
        return <NumberInput {...common} field={field} value={typeof constant === "number" ? constant : undefined} set={set} />;
      case "choice":
        return <ChoiceField {...common} choices={field.choices} value={constant} set={(next) => set(exactConstant(next, about.type))} />;
      case "pose":
        return <PoseField step={state} name={about.name} {...common} value={typeof constant === "string" ? constant : undefined} set={set} />;
      case "label":
        return <LabelField step={state} {...common} value={typeof constant === "string" ? constant : ""} set={set} />;
      case "labels":
        return <LabelsField step={state} {...common} values={items} set={set} />;
      case "texts":
        return about.name === "labels" ? <LabelsField step={state} {...common} values={items} set={set} /> : <TextsField {...common} known={[]} values={items} set={set} />;
      case "colour":
        return <ColourField {...common} value={typeof constant === "string" ? constant : ""} set={set} />;
      case "text":
        return <TextField {...common} value={typeof constant === "string" ? constant : ""} set={set} isLong={about.domain === "text"} />;
      case "toggle":
        return <ToggleField {...common} value={constant === true} set={set} />;
      case "other":
        return <output id={id} className="fixed">{constant === undefined ? t.ofPro : valueText(about, constant)}</output>;
    }
  };
  return (
    <div className={problem === undefined ? "parameter" : "parameter is-missing"} data-parameter={about.name}>
      {field.kind !== "toggle" && <label htmlFor={id}>{about.title}</label>}
      {entry()}
      {problem !== undefined && <p className="problem">{problem}</p>}
      {about.doc !== undefined && <p className="doc">{about.doc}</p>}
      {isElsewhere && <p className="doc">{t.usedElsewhere}</p>}
    </div>
  );
}

interface FoundProps {
  readonly id: string;
  readonly label: string;
  readonly disabled: boolean;
  readonly state: string;
  readonly line: TimeLine;
  readonly name: string;
  readonly domain: string | undefined;
  /** The step that gives it now. */
  readonly taken: string | undefined;
}

/** Which of the steps before gives the part. */
function FoundField({ id, disabled, state, line, name, domain, taken }: FoundProps) {
  const tree = useTree();
  const sources = tree === undefined ? [] : sourcesOf(tree, line.steps, state, domain);
  const titleOf = (step: string) => line.steps.find((each) => each.id === step)?.title ?? t.stepBefore;
  if (sources.length === 0 && taken === undefined) return <output id={id} className="fixed">{t.noFinder}</output>;
  return (
    <select
      id={id}
      disabled={disabled}
      value={taken ?? ""}
      onChange={(event) => {
        const source = sources.find(({ step }) => step === event.target.value);
        if (source !== undefined) perform((now, supplies) => setSource(now, state, name, source, supplies));
      }}
    >
      {taken === undefined && <option value="">{t.choose}</option>}
      {taken !== undefined && !sources.some(({ step }) => step === taken) && <option value={taken}>{t.off(titleOf(taken))}</option>}
      {sources.map(({ step }) => (
        <option key={step} value={step}>
          {t.foundBy(titleOf(step))}
        </option>
      ))}
    </select>
  );
}
