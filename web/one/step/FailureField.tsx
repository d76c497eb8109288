// What is done if a step fails, and where its other outcomes lead.
import { setFailure, setOutcome } from "../../shared/timeline/changes/failure";
import type { Failure, Goes, Step, Then, TimeLine } from "../../shared/timeline/timeLine";
import { perform } from "../editing";
import { ownerOf } from "./StepPanel";
import { ParameterField } from "./ParameterField";
import { texts } from "../texts";

const t = texts.step;
/** `leave`: of steps that are repeated. */
const kKinds: readonly Failure["kind"][] = ["stop", "retry", "ask", "next", "leave"];
const kThens: readonly Then[] = ["stop", "ask", "next", "leave"];

interface Props {
  readonly step: Step;
  readonly line: TimeLine;
  readonly disabled: boolean;
}

export function FailureField({ step, line, disabled }: Props) {
  const { failure, errors, times } = step;
  if (failure === undefined) return null;
  const isOffered = (what: string) => what !== "leave" || line.isRepeated;
  const set = (next: Failure) => void perform((tree, supplies) => setFailure(tree, step.id, next, supplies));
  return (
    <fieldset className="failure" disabled={disabled}>
      <legend>{t.ifItFails}</legend>
      {kKinds.filter(isOffered).map((kind) => (
        <label key={kind} className="radio">
          <input type="radio" name={`failure-${step.id}`} checked={failure.kind === kind} onChange={() => set(kind === "retry" ? { kind, then: failure.kind === "retry" ? failure.then : failure.kind } : { kind })} />
          <span>{t.failures[kind]}</span>
        </label>
      ))}
      {failure.kind === "retry" && (
        <>
          {times !== undefined && <ParameterField state={ownerOf(times)} line={line} parameter={times} problem={undefined} disabled={disabled} />}
          <label className="then">
            <span>{t.ifItFailsStill}</span>
            <select value={failure.then} onChange={(event) => set({ kind: "retry", then: kThens.find((then) => then === event.target.value) ?? "stop" })}>
              {kThens.filter(isOffered).map((then) => (
                <option key={then} value={then}>
                  {t.thens[then]}
                </option>
              ))}
            </select>
          </label>
        </>
      )}
      <details>
        <summary>{t.errors}</summary>
        <ul className="errors">
          {errors.map(({ name, title, advice }) => (
            <li key={name}>
              <b>{t.errorTitle(title)}</b> {advice}
            </li>
          ))}
        </ul>
      </details>
    </fieldset>
  );
}

const kWays: readonly Goes[] = ["next", "end"];
const kWaysOfLoop: readonly Goes[] = ["next", "end", "leave"];

export function OutcomeFields({ step, line, disabled }: Props) {
  return step.outcomes.map(({ port, goes }) => (
    <fieldset key={port.name} className="failure" disabled={disabled}>
      <legend>{t.outcome(port.title)}</legend>
      {(line.isRepeated ? kWaysOfLoop : kWays).map((way) => (
        <label key={way} className="radio">
          <input type="radio" name={`${step.id}-${port.name}`} checked={goes === way} onChange={() => void perform((tree, supplies) => setOutcome(tree, step.id, port.name, way, supplies))} />
          <span>{(line.isRepeated ? t.outcomesOfLoop : t.outcomes)[way]}</span>
        </label>
      ))}
    </fieldset>
  ));
}
