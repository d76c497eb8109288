// A task that is selected: its name, and what can be done with it.
import { refusalTo } from "../../shared/login/doings";
import type { Step, TimeLine } from "../../shared/timeline/timeLine";
import { useLogin } from "../client";
import { duplicate, moveBy, remove, turn } from "./actions";
import { FailureField } from "./FailureField";
import { ParameterField } from "./ParameterField";
import { TitleField } from "./StepPanel";

interface Props {
  readonly step: Step;
  readonly line: TimeLine;
  /** The tasks of the application can be changed. */
  readonly isEditable: boolean;
}

export function TaskPanel({ step, line, isEditable }: Props) {
  const refusal = useLogin((login) => refusalTo(login.me, "edit"));
  const disabled = refusal !== undefined || !isEditable;
  const at = line.steps.findIndex(({ id }) => id === step.id);
  return (
    <>
      <TitleField step={step} isEditable={!disabled} />
      {step.inner !== undefined && step.inner.form !== "editable" && (
        <p className="notice">
          This task can be looked at and run, and its values can be set: {step.inner.reason}. RACE Pro changes it.
        </p>
      )}
      <section aria-label="Settings" className="parameters">
        {step.parameters.filter(({ about }) => !about.internal).map((parameter) => (
          <ParameterField key={parameter.about.name} state={step.id} line={line} parameter={parameter} problem={undefined} disabled={refusal !== undefined} />
        ))}
      </section>
      {isEditable && (
        <>
          <FailureField step={step} line={line} disabled={disabled} />
          <section aria-label="This task" className="tools">
            <h3>This task</h3>
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
              <button type="button" className="danger" disabled={disabled} onClick={() => remove(step.id)}>
                Remove
              </button>
            </div>
          </section>
        </>
      )}
    </>
  );
}
