// Moves a step into another task or loop, behind all that is there: what a drag does, for the keyboard.
import { useState } from "react";
import type { Application } from "../../shared/timeline/read";
import type { Step, TimeLine } from "../../shared/timeline/timeLine";
import { everyStep, findStep } from "../model";
import { dropStep } from "./actions";
import { texts } from "../texts";

interface Props {
  readonly step: Step;
  readonly line: TimeLine;
  readonly application: Application;
  readonly disabled: boolean;
}

export function MoveTo({ step, line, application, disabled }: Props) {
  const places = everyStep(application).filter(({ id, inner }) => inner?.form === "editable" && inner.id !== line.id && id !== step.id && (step.inner === undefined || findStep(step.inner, id) === undefined));
  const [chosen, setChosen] = useState("");
  if (places.length === 0) return null;
  const place = places.find(({ id }) => id === chosen) ?? places[0];
  return (
    <div className="repeat">
      <label>
        <span>{texts.step.moveTo}</span>
        <select disabled={disabled} value={place?.id} onChange={(event) => setChosen(event.target.value)}>
          {places.map(({ id, title }) => (
            <option key={id} value={id}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <button type="button" disabled={disabled} onClick={() => place?.inner !== undefined && dropStep(step.id, { composite: place.inner.id, index: place.inner.steps.length })}>
        {texts.step.move}
      </button>
    </div>
  );
}
