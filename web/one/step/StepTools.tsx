// What can be done with a step or task as a whole: each button does what a drag or a key does, too.
import { useState, type ReactNode } from "react";
import type { Step, TimeLine } from "../../shared/timeline/timeLine";
import { duplicate, moveBy, remove, repeat, repeatNoMore, turn } from "./actions";
import { texts } from "../texts";

const t = texts.step;

interface Props {
  readonly step: Step;
  readonly line: TimeLine;
  readonly disabled: boolean;
  readonly children?: ReactNode;
}

export function StepTools({ step, line, disabled, children }: Props) {
  const at = line.steps.findIndex(({ id }) => id === step.id);
  const following = line.steps.slice(at);
  const [until, setUntil] = useState(step.id);
  const heading = step.kind === "task" ? t.thisTask : t.thisStep;
  const last = following.findIndex(({ id }) => id === until);
  return (
    <section aria-label={heading} className="tools">
      <h3>{heading}</h3>
      <div className="buttons">
        <button type="button" disabled={disabled || at === 0} onClick={() => moveBy(step.id, -1)}>
          {t.earlier}
        </button>
        <button type="button" disabled={disabled || at === line.steps.length - 1} onClick={() => moveBy(step.id, 1)}>
          {t.later}
        </button>
        <button type="button" disabled={disabled} onClick={() => void duplicate(step.id)}>
          {t.duplicate}
        </button>
        <button type="button" disabled={disabled} onClick={() => turn(step.id, !step.disabled)}>
          {step.disabled ? t.turnOn : t.turnOff}
        </button>
        {step.kind === "loop" && (
          <button type="button" disabled={disabled} onClick={() => repeatNoMore(step.id)}>
            {t.repeatNoMore}
          </button>
        )}
        <button type="button" className="danger" disabled={disabled} onClick={() => remove(step.id)}>
          {t.remove}
        </button>
      </div>
      {children}
      <div className="repeat">
        <label>
          <span>{t.repeatTo}</span>
          <select disabled={disabled} value={until} onChange={(event) => setUntil(event.target.value)}>
            {following.map(({ id, title }) => (
              <option key={id} value={id}>
                {title}
              </option>
            ))}
          </select>
        </label>
        <button type="button" disabled={disabled} onClick={() => repeat(following.slice(0, Math.max(0, last) + 1).map(({ id }) => id))}>
          {t.repeat}
        </button>
      </div>
    </section>
  );
}
