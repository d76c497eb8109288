// A task that is selected: its name, and what can be done with it.
import type { Step, TimeLine } from "../../shared/timeline/timeLine";
import { useRefusal } from "../client";
import { FailureField } from "./FailureField";
import { ParameterField } from "./ParameterField";
import { RepeatField } from "./RepeatField";
import { TitleField } from "./StepPanel";
import { StepTools } from "./StepTools";
import { texts } from "../texts";

interface Props {
  readonly step: Step;
  readonly line: TimeLine;
  /** The tasks of the application can be changed. */
  readonly isEditable: boolean;
}

export function TaskPanel({ step, line, isEditable }: Props) {
  const refusal = useRefusal("edit");
  const disabled = refusal !== undefined || !isEditable;
  return (
    <>
      <TitleField step={step} isEditable={!disabled} />
      {step.inner !== undefined && step.inner.form !== "editable" && (
        <p className="notice">{texts.step.richTask(step.inner.reason ?? "")}</p>
      )}
      <section aria-label={texts.step.settings} className="parameters">
        {step.parameters.filter(({ about }) => !about.internal).map((parameter) => (
          <ParameterField key={parameter.about.name} state={step.id} line={line} parameter={parameter} problem={undefined} disabled={refusal !== undefined} />
        ))}
        <RepeatField loop={step} line={line} disabled={disabled} />
      </section>
      {isEditable && (
        <>
          <FailureField step={step} line={line} disabled={disabled} />
          <StepTools step={step} line={line} disabled={disabled} />
        </>
      )}
    </>
  );
}
