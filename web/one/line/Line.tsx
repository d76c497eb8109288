// A time line: its steps as cards, one after the other.
import { Fragment } from "react";
import type { StepProblem } from "../../shared/timeline/problems";
import type { TimeLine } from "../../shared/timeline/timeLine";
import { select } from "../select";
import { showSheet } from "../sheet";
import { texts } from "../texts";
import { useDragged } from "./drag";
import { StepCard } from "./StepCard";

interface Props {
  readonly line: TimeLine;
  readonly problems: readonly StepProblem[];
}

export function Line({ line, problems }: Props) {
  const isEditable = line.form === "editable";
  const moved = useDragged((drag) => (drag?.what.kind === "step" ? drag.what.id : undefined));
  const over = useDragged((drag) => (drag?.over?.composite === line.id ? drag.over.index : undefined));
  const places = line.steps.filter(({ id }) => id !== moved);
  const again = line.again === undefined ? undefined : line.steps.find(({ id }) => id === line.again);
  return (
    <>
      <ol className={`line is-${line.form}`} {...(isEditable && { "data-composite": line.id })}>
        {line.steps.map((step) => (
          <Fragment key={step.id}>
            {over !== undefined && places[over]?.id === step.id && <li className="drop-here" aria-hidden="true" />}
            <StepCard step={step} problems={problems} isEditable={isEditable} />
          </Fragment>
        ))}
        {over === places.length && <li className="drop-here" aria-hidden="true" />}
        {again !== undefined && <li className="again">{texts.line.again(again.title)}</li>}
        {isEditable && (
          <li className="add-step">
            <button
              type="button"
              onClick={() => {
                select(line.steps.at(-1)?.id ?? line.id, false);
                showSheet("library");
                document.querySelector<HTMLElement>(".skills input[type=search]")?.focus();
              }}
            >
              {line.steps.length === 0 ? texts.line.addFirst : texts.line.add}
            </button>
          </li>
        )}
      </ol>
      {line.others.length > 0 && (
        <details className="others">
          <summary>{texts.line.more(line.others.length)}</summary>
          <ul className="line">
            {line.others.map((step) => (
              <StepCard key={step.id} step={step} problems={problems} isEditable={false} />
            ))}
          </ul>
        </details>
      )}
    </>
  );
}
