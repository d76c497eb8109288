// What is selected: its parameters, what is done if it fails, and what can be done with it.
import { useState } from "react";
import { refusalTo } from "../../shared/login/doings";
import type { Application } from "../../shared/timeline/read";
import { renameStep } from "../../shared/timeline/changes/steps";
import type { Step, TimeLine } from "../../shared/timeline/timeLine";
import { useLogin } from "../client";
import { perform } from "../editing";
import { useProblems } from "../model";
import { Picture } from "../Picture";
import { duplicate, moveBy, remove, repeat, repeatNoMore, turn } from "./actions";
import { FailureField, OutcomeFields } from "./FailureField";
import { MoveTo } from "./MoveTo";
import { ParameterField } from "./ParameterField";

interface Props {
  readonly step: Step;
  readonly line: TimeLine;
  readonly application: Application;
}

export function StepPanel({ step, line, application }: Props) {
  const refusal = useLogin((login) => refusalTo(login.me, "edit"));
  const isEditable = line.form === "editable" && refusal === undefined;
  return (
    <>
      <TitleField step={step} isEditable={isEditable} />
      {step.about.doc !== undefined && <p className="doc">{step.about.doc}</p>}
      {line.form !== "editable" && <p className="notice">This step was made in RACE Pro. Its values can be set here; where it leads can be changed there.</p>}
      {refusal !== undefined && <p className="notice">You can look at it: {refusal}.</p>}
      <Parameters step={step} line={line} disabled={refusal !== undefined} />
      {step.repeat !== undefined && <ParameterField key="repeat" state={ownerOf(step.repeat)} line={line} parameter={step.repeat} problem={undefined} disabled={!isEditable} />}
      {line.form === "editable" && (
        <>
          <FailureField step={step} line={line} disabled={!isEditable} />
          <OutcomeFields step={step} disabled={!isEditable} />
          <StepTools step={step} line={line} application={application} disabled={!isEditable} />
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
        <input aria-label="Name" maxLength={40} value={draft ?? step.title} onChange={(event) => setDraft(event.target.value)} onBlur={commit} onKeyDown={(event) => event.key === "Enter" && commit()} />
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
    <section aria-label="Settings" className="parameters">
      {problems.filter((problem) => problem.parameter === undefined).map(({ text }) => <p key={text} className="problem">{text}</p>)}
      {usual.map(field)}
      {advanced.length > 0 && (
        <details>
          <summary>More settings</summary>
          {advanced.map(field)}
        </details>
      )}
    </section>
  );
}

function StepTools({ step, line, application, disabled }: Props & { readonly disabled: boolean }) {
  const at = line.steps.findIndex(({ id }) => id === step.id);
  const following = line.steps.slice(at);
  const [until, setUntil] = useState(step.id);
  const last = following.findIndex(({ id }) => id === until);
  return (
    <section aria-label="This step" className="tools">
      <h3>This step</h3>
      <div className="buttons">
        <button type="button" disabled={disabled || at === 0} onClick={() => moveBy(step.id, -1)}>
          Earlier
        </button>
        <button type="button" disabled={disabled || at === line.steps.length - 1} onClick={() => moveBy(step.id, 1)}>
          Later
        </button>
        <button type="button" disabled={disabled} onClick={() => void duplicate(step.id)}>
          Duplicate
        </button>
        <button type="button" disabled={disabled} onClick={() => turn(step.id, !step.disabled)}>
          {step.disabled ? "Turn on" : "Turn off"}
        </button>
        {step.kind === "loop" && (
          <button type="button" disabled={disabled} onClick={() => repeatNoMore(step.id)}>
            Do not repeat
          </button>
        )}
        <button type="button" className="danger" disabled={disabled} onClick={() => remove(step.id)}>
          Remove
        </button>
      </div>
      <MoveTo step={step} line={line} application={application} disabled={disabled} />
      <div className="repeat">
        <label>
          <span>Repeat from here to</span>
          <select disabled={disabled} value={until} onChange={(event) => setUntil(event.target.value)}>
            {following.map(({ id, title }) => (
              <option key={id} value={id}>
                {title}
              </option>
            ))}
          </select>
        </label>
        <button type="button" disabled={disabled} onClick={() => repeat(following.slice(0, Math.max(0, last) + 1).map(({ id }) => id))}>
          Repeat
        </button>
      </div>
    </section>
  );
}
