// What is selected: its parameters, what is done if it fails, and what can be done with it.
import { useState } from "react";
import type { Application } from "../../shared/timeline/read";
import { renameStep } from "../../shared/timeline/changes/steps";
import type { Step, TimeLine } from "../../shared/timeline/timeLine";
import { useRefusal } from "../client";
import { perform } from "../editing";
import { useProblems } from "../model";
import { Picture } from "../Picture";
import { MoveTo } from "./MoveTo";
import { FailureField, OutcomeFields } from "./FailureField";
import { ParameterField } from "./ParameterField";
import { RepeatField } from "./RepeatField";
import { StepTools } from "./StepTools";
import { texts } from "../texts";

const t = texts.step;

interface Props {
  readonly step: Step;
  readonly line: TimeLine;
  readonly application: Application;
}

export function StepPanel({ step, line, application }: Props) {
  const refusal = useRefusal("edit");
  const isEditable = line.form === "editable" && refusal === undefined;
  return (
    <>
      <TitleField step={step} isEditable={isEditable} />
      {step.about.doc !== undefined && <p className="doc">{step.about.doc}</p>}
      {line.form !== "editable" && <p className="notice">{t.ofPro}</p>}
      {refusal !== undefined && <p className="notice">{t.onlyToLookAt(refusal)}</p>}
      <Parameters step={step} line={line} disabled={refusal !== undefined} />
      <RepeatField loop={step} line={line} disabled={!isEditable} />
      {line.form === "editable" && (
        <>
          <FailureField step={step} line={line} disabled={!isEditable} />
          <OutcomeFields step={step} line={line} disabled={!isEditable} />
          <StepTools step={step} line={line} disabled={!isEditable}>
            <MoveTo step={step} line={line} application={application} disabled={!isEditable} />
          </StepTools>
        </>
      )}
    </>
  );
}

/** The state at which a parameter is set. */
export const ownerOf = ({ value }: Step["parameters"][number]): string => (value.kind === "constant" || value.kind === "missing" ? value.state : "");

export function TitleField({ step, isEditable }: { readonly step: Step; readonly isEditable: boolean }) {
  const [draft, setDraft] = useState<string>();
  const commit = () => {
    if (draft !== undefined && draft.trim() !== "" && draft !== step.title) perform((tree, supplies) => renameStep(tree, step.id, draft, supplies));
    setDraft(undefined);
  };
  return (
    <div className="panel-title">
      <Picture name={step.kind === "loop" ? "repeat" : step.kind === "task" ? "task" : step.about.icon} category={step.about.category} />
      {isEditable ? (
        <input aria-label={t.name} maxLength={40} value={draft ?? step.title} onChange={(event) => setDraft(event.target.value)} onBlur={commit} onKeyDown={(event) => event.key === "Enter" && commit()} />
      ) : (
        <h2>{step.title}</h2>
      )}
    </div>
  );
}

function Parameters({ step, line, disabled }: { readonly step: Step; readonly line: TimeLine; readonly disabled: boolean }) {
  const problems = useProblems().filter((problem) => problem.step === step.id);
  const shown = step.parameters.filter(({ about }) => !about.internal);
  const [usual, advanced] = [shown.filter(({ about }) => !about.advanced), shown.filter(({ about }) => about.advanced)];
  const field = (parameter: Step["parameters"][number]) => (
    <ParameterField key={parameter.about.name} state={step.id} line={line} parameter={parameter} disabled={disabled} problem={problems.find((problem) => problem.parameter === parameter.about.name)?.text} />
  );
  return (
    <section aria-label={t.settings} className="parameters">
      {problems.filter((problem) => problem.parameter === undefined).map(({ text }) => <p key={text} className="problem">{text}</p>)}
      {usual.map(field)}
      {advanced.length > 0 && (
        <details>
          <summary>{t.moreSettings}</summary>
          {advanced.map(field)}
        </details>
      )}
    </section>
  );
}
