// What is done if a step fails, and where its other outcomes lead.
import { setFailure, setOutcome } from "../../shared/timeline/changes/failure";
import type { Failure, Step, Then, TimeLine } from "../../shared/timeline/timeLine";
import { perform } from "../editing";
import { ownerOf } from "./StepPanel";
import { ParameterField } from "./ParameterField";

const kKinds: readonly (readonly [kind: Failure["kind"], text: string])[] = [["stop", "Stop the task"], ["retry", "Try again"], ["ask", "Ask a person"], ["next", "Go on with the next step"]];
const kThens: readonly (readonly [then: Then, text: string])[] = [["stop", "stop the task"], ["ask", "ask a person"], ["next", "go on with the next step"]];

interface Props {
  readonly step: Step;
  readonly line: TimeLine;
  readonly disabled: boolean;
}

export function FailureField({ step, line, disabled }: Props) {
  const { failure, errors, times } = step;
  if (failure === undefined) return null;
  const set = (next: Failure) => void perform((tree, supplies) => setFailure(tree, step.id, next, supplies));
  return (
    <fieldset className="failure" disabled={disabled}>
      <legend>If it fails</legend>
      {kKinds.map(([kind, text]) => (
        <label key={kind} className="radio">
          <input type="radio" name={`failure-${step.id}`} checked={failure.kind === kind} onChange={() => set(kind === "retry" ? { kind, then: failure.kind === "retry" ? failure.then : failure.kind } : { kind })} />
          <span>{text}</span>
        </label>
      ))}
      {failure.kind === "retry" && (
        <>
          {times !== undefined && <ParameterField state={ownerOf(times)} line={line} parameter={times} problem={undefined} disabled={disabled} />}
          <label className="then">
            <span>If it fails still</span>
            <select value={failure.then} onChange={(event) => set({ kind: "retry", then: kThens.find(([then]) => then === event.target.value)?.[0] ?? "stop" })}>
              {kThens.map(([then, text]) => (
                <option key={then} value={then}>
                  {text}
                </option>
              ))}
            </select>
          </label>
        </>
      )}
      <details>
        <summary>What can go wrong</summary>
        <ul className="errors">
          {errors.map(({ name, title, advice }) => (
            <li key={name}>
              <b>{title}.</b> {advice}
            </li>
          ))}
        </ul>
      </details>
    </fieldset>
  );
}

export function OutcomeFields({ step, disabled }: { readonly step: Step; readonly disabled: boolean }) {
  return step.outcomes.map(({ port, goes }) => (
    <fieldset key={port.name} className="failure" disabled={disabled}>
      <legend>“{port.title}”</legend>
      {(["next", "end"] as const).map((way) => (
        <label key={way} className="radio">
          <input type="radio" name={`${step.id}-${port.name}`} checked={goes === way} onChange={() => void perform((tree, supplies) => setOutcome(tree, step.id, port.name, way, supplies))} />
          <span>{way === "next" ? "Go on with the next step" : "The task is done"}</span>
        </label>
      ))}
    </fieldset>
  ));
}
