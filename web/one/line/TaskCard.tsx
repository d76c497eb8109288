// A task: its name, and its time line.
import type { StepProblem } from "../../shared/timeline/problems";
import type { Step } from "../../shared/timeline/timeLine";
import { usePlace } from "../place";
import { select } from "../select";
import { texts } from "../texts";
import { Line } from "./Line";
import { repeatText } from "./repeatText";

interface Props {
  readonly task: Step;
  readonly index: number;
  readonly count: number;
  readonly problems: readonly StepProblem[];
}

export function TaskCard({ task, index, count, problems }: Props) {
  const isSelected = usePlace((place) => place.task === task.id && place.step === undefined);
  const line = task.inner;
  return (
    <section className={`task${task.disabled ? " is-off" : ""}${isSelected ? " is-selected" : ""}`} aria-label={texts.line.task(task.title)} data-step={task.id}>
      <header>
        <button type="button" className="card-open" aria-pressed={isSelected} onClick={() => select(task.id)}>
          {count > 1 && <span className="number">{index + 1}</span>}
          <strong>{task.title}</strong>
          {task.disabled && <small>{texts.line.off}</small>}
          {task.repeat !== undefined && <small>{repeatText(task)}</small>}
          {line !== undefined && line.form !== "editable" && <small>{texts.line.toLookAt}</small>}
        </button>
        {task.about.doc !== undefined && <p>{task.about.doc}</p>}
      </header>
      {line !== undefined && <Line line={line} problems={problems} />}
    </section>
  );
}
