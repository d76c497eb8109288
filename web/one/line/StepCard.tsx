// A step: its picture and name, its most important value, and what is done if it fails.
import { fieldOf, valueText } from "../../shared/skills/form";
import type { StepProblem } from "../../shared/timeline/problems";
import type { Failure, Step, StepParameter } from "../../shared/timeline/timeLine";
import { Picture } from "../Picture";
import { useUntaught } from "../model";
import { usePlace } from "../place";
import { select } from "../select";
import { UntaughtPose } from "../step/Untaught";
import { texts } from "../texts";
import { useDrag, useDragged } from "./drag";
import { Line } from "./Line";
import { repeatText } from "./repeatText";

const t = texts.line;

interface Props {
  readonly step: Step;
  readonly problems: readonly StepProblem[];
  readonly isEditable: boolean;
}

/** `3 ×` */
function timesText(times: StepParameter | undefined): string {
  const value = times?.value.kind === "constant" ? times.value.value : undefined;
  return typeof value === "number" ? t.times(value) : "";
}

export function failureText(failure: Failure, times: StepParameter | undefined): string {
  return failure.kind === "retry" ? t.retry(timesText(times), t.then[failure.then]) : t.then[failure.kind];
}

/** What tells a step from others of its kind, best first. */
const kTelling = ["pose", "labels", "label", "texts", "text", "choice"] as const;

/** Of more values, none tells a step from others. */
const kFew = 2;

/** The value that says most; of a step that nobody has described, none but what it says or looks for. */
export function summaryOf({ parameters }: Step): string {
  const shown = parameters.flatMap(({ about, value }) => (value.kind === "constant" && !about.internal && !about.advanced ? [{ about, value: value.value, kind: fieldOf(about, value.value).kind }] : []));
  const telling = kTelling.map((kind) => shown.find((each) => each.kind === kind)).find((each) => each !== undefined);
  const found = telling ?? (shown.length <= kFew ? shown.find(({ about }) => about.domain !== undefined) : undefined);
  return found === undefined ? "" : valueText(found.about, found.value);
}

export function StepCard({ step, problems, isEditable }: Props) {
  const isSelected = usePlace((place) => place.step === step.id);
  const drag = useDrag({ kind: "step", title: step.title, id: step.id });
  const isDragged = useDragged((now) => now?.what.kind === "step" && now.what.id === step.id);
  const problem = problems.find((each) => each.step === step.id);
  const untaught = useUntaught().filter((each) => each.step === step.id);
  const { about, title, disabled, failure, inner } = step;
  const summary = inner === undefined ? summaryOf(step) : "";
  const icon = step.kind === "loop" ? "repeat" : step.kind === "task" ? "task" : about.icon;
  const looks = [`step is-${about.category ?? "other"}`, disabled && "is-off", isSelected && "is-selected", isDragged && "is-dragged", inner !== undefined && "is-group"].filter(Boolean).join(" ");
  return (
    <li className={looks} data-step={step.id}>
      <div className="card">
        <button type="button" className="card-open" aria-pressed={isSelected} onPointerDown={isEditable ? drag.fromCard : undefined} onClick={(click) => drag.isClick(click) && select(step.id)}>
          <Picture name={icon} category={about.category} />
          <strong>{title}</strong>
          {summary !== "" && <span className="summary">{summary}</span>}
          {step.repeat !== undefined && <span className="summary">{repeatText(step)}</span>}
          {disabled && <span className="mark">{t.off}</span>}
          {failure !== undefined && failure.kind !== "stop" && <span className="mark">{t.ifItFails(failureText(failure, step.times))}</span>}
          {problem !== undefined && <span className="mark is-problem">{problem.text}</span>}
        </button>
        {untaught.map((each) => (
          <UntaughtPose key={each.parameter} untaught={each} />
        ))}
        {isEditable && <i className="grip" aria-hidden="true" onPointerDown={drag.fromGrip} />}
      </div>
      {inner !== undefined && <Line line={inner} problems={problems} />}
    </li>
  );
}
