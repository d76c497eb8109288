// The application of both places is made, and shown as what it is: a row of steps.
import { useApplication } from "../model";
import { Picture } from "../Picture";
import { go, usePlace } from "../place";
import { summaryOf } from "../line/StepCard";
import { texts } from "../texts";
import { makeApplication } from "./make";
import { useMaking } from "./useMaking";
import { Ways } from "./Ways";

const t = texts.application;

export function ApplicationStep() {
  const [edit, part, goal] = [usePlace((place) => place.edit), usePlace((place) => place.part), usePlace((place) => place.goal)];
  const { busy, problem, make } = useMaking(async () => {
    if (part === undefined || goal === undefined) return;
    await makeApplication(t.wish, t.task, [
      { skill: "PickAt", values: { pose: part } },
      { skill: "PlaceAt", values: { pose: goal } },
    ]);
  });
  const canMake = part !== undefined && goal !== undefined;
  return (
    <main className="guided-body">
      {edit === undefined && !canMake && <p className="problem">{t.missingPoses}</p>}
      {(edit === undefined || busy) && canMake && (
        <button type="button" className="main" disabled={busy} onClick={make}>
          {busy ? t.making : t.make}
        </button>
      )}
      {problem !== undefined && <p className="problem" role="alert">{texts.problem(problem)}</p>}
      {edit !== undefined && !busy && <MadeLine />}
      {edit !== undefined && !busy && (
        <button type="button" className="link" onClick={() => go({ guide: undefined, part: undefined, goal: undefined, view: "build" })}>
          {t.change}
        </button>
      )}
      <Ways step="application" isReady={edit !== undefined && !busy} />
    </main>
  );
}

function MadeLine() {
  const steps = useApplication()?.tasks.flatMap(({ inner }) => inner?.steps ?? []) ?? [];
  return (
    <ol className="line guided-line" aria-label={t.line}>
      {steps.map((step) => (
        <li key={step.id} className={`step is-${step.about.category ?? "other"}`}>
          <Picture name={step.about.icon} category={step.about.category} />
          <strong>{step.title}</strong>
          <span className="summary">{summaryOf(step)}</span>
        </li>
      ))}
    </ol>
  );
}
