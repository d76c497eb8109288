// The application of both places is made, and shown as what it is: a row of steps.
import { useApplication } from "../model";
import { Picture } from "../Picture";
import { go, usePlace } from "../place";
import { summaryOf } from "../line/StepCard";
import { texts } from "../texts";
import { MakeButton } from "./MakeButton";
import { useMaking } from "./useMaking";
import { Ways } from "./Ways";

const t = texts.application;

export function ApplicationStep() {
  const [part, goal] = [usePlace((place) => place.part), usePlace((place) => place.goal)];
  const making = useMaking(t.wish, t.task, [
    { skill: "PickAt", values: part === undefined ? {} : { pose: part } },
    { skill: "PlaceAt", values: goal === undefined ? {} : { pose: goal } },
  ]);
  const { made, busy, problem } = making;
  const canMake = part !== undefined && goal !== undefined;
  // What the server has not answered is no application yet.
  const isThere = made === "yes" && !busy && problem === undefined;
  return (
    <main className="guided-body">
      {made === "no" && !canMake && <p className="problem">{t.missingPoses}</p>}
      {made === "opening" && !busy && problem === undefined && <p role="status">{t.opening}</p>}
      {canMake && !isThere && (made !== "opening" || busy || problem !== undefined) && <MakeButton {...making} label={t.make} making={t.making} />}
      {isThere && <MadeLine />}
      {isThere && (
        <button type="button" className="link" onClick={() => go({ guide: undefined, part: undefined, goal: undefined, view: "build" })}>
          {t.change}
        </button>
      )}
      <Ways step="application" isReady={isThere} />
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
