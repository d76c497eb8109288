// How often a loop repeats: so many times, or until one of its steps says so.
import { repeatUntil } from "../../shared/timeline/changes/loop";
import { endsOf, failuresThatEnd, type End } from "../../shared/timeline/until";
import type { Step, TimeLine } from "../../shared/timeline/timeLine";
import { perform } from "../editing";
import { ParameterField } from "./ParameterField";
import { ownerOf } from "./StepPanel";
import { texts } from "../texts";

const t = texts.step;

interface Props {
  readonly loop: Step;
  readonly line: TimeLine;
  readonly disabled: boolean;
}

export function RepeatField({ loop, line, disabled }: Props) {
  const { repeat } = loop;
  if (repeat === undefined) return null;
  const ends = endsOf(loop);
  const failing = failuresThatEnd(loop);
  const isCounted = repeat.value.kind !== "constant" || repeat.value.value !== 0;
  const isEnded = failing.length > 0 || ends.some(({ isChosen }) => isChosen);
  const set = ({ step, port }: End, isEnd: boolean) => void perform((tree, supplies) => repeatUntil(tree, loop.id, { step: step.id, port }, isEnd, supplies));
  return (
    <fieldset className="failure" disabled={disabled}>
      <legend>{t.howOften}</legend>
      {(isCounted || !isEnded) && <ParameterField state={ownerOf(repeat)} line={line} parameter={repeat} problem={undefined} disabled={disabled} />}
      {ends.map((end) => (
        <label key={`${end.step.id}-${end.port}`} className="radio">
          <input type="checkbox" checked={end.isChosen} onChange={(event) => set(end, event.target.checked)} />
          <span>{t.until(end.step.title, end.title)}</span>
        </label>
      ))}
      {failing.map(({ id, title }) => (
        <p key={id} className="doc">
          {t.untilItFails(title)}
        </p>
      ))}
      {loop.inner?.steps.some(({ kind }) => kind === "task") === true && <p className="doc">{t.untilWithinTask}</p>}
    </fieldset>
  );
}
