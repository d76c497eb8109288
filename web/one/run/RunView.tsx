// The run of the application: what happens now, what is next, what went wrong, and the buttons to begin, hold and end it.
import { useEffect, useMemo } from "react";
import { goesOnMeanwhile, isBadOutcome, isOver, statusLook } from "../../shared/run/controls";
import { activeIds, kNoProgress, progressIn, type Progress } from "../../shared/timeline/progress";
import { failureText } from "../line/StepCard";
import { useCore, useSession } from "../client";
import { useApplication } from "../model";
import { Picture } from "../Picture";
import { Asked } from "./Asked";
import { becomeDisplay } from "./display";
import { treeOfRun, useFailure } from "./failed";
import { Finished } from "./Finished";
import { ModeHere } from "./ModeHere";
import { RunButtons } from "./RunButtons";

export function RunView({ name }: { readonly name: string }) {
  const application = useApplication();
  const core = useCore();
  const active = useSession((s) => s.run?.active);
  const model = useSession((s) => s.model);
  const failure = useFailure(application);
  useEffect(becomeDisplay, []);
  const progress = useMemo(() => {
    const tree = treeOfRun({ model });
    return application === undefined || tree === undefined || active === undefined ? kNoProgress : progressIn(application.root, activeIds(active, tree));
  }, [application, model, active]);
  const isGoing = core !== undefined && !isOver(core) && core.status !== "ready";
  const look = core === undefined ? "ready" : statusLook(core);
  const step = progress.now.at(-1);
  return (
    <main className={`run is-${look}`} aria-label="Run">
      <section className="now" aria-label="Now">
        <p className="status" role="status" aria-label="Run status">
          {statusOf(look)}
        </p>
        <Headline title={isGoing ? (step?.title ?? "…") : core !== undefined && isOver(core) ? endOf(look) : "Ready to start"} icon={isGoing ? step?.about.icon : undefined} />
        {isGoing && progress.now.length > 1 && <p className="within">{progress.now.slice(0, -1).map(({ title }) => title).join(" › ")}</p>}
        {isGoing && progress.next !== undefined && (
          <p className="next">
            Next: <b>{progress.next.title}</b>
          </p>
        )}
        {core !== undefined && <p className="quiet">{goesOnMeanwhile(core)}</p>}
        {isGoing && progress.line !== undefined && <Steps progress={progress} />}
      </section>
      {failure !== undefined && (core === undefined || isOver(core) || progress.failing || step?.id !== failure.step.id) && (
        <section className="wrong" aria-label="What went wrong">
          <h2>
            {failure.step.title}: {failure.title}
          </h2>
          {failure.why !== undefined && <p>{failure.why}</p>}
          {failure.advice !== "" && <p className="advice">{failure.advice}</p>}
          {isGoing && failure.step.failure !== undefined && <p className="quiet">If it fails: {failureText(failure.step.failure, failure.step.times)}.</p>}
        </section>
      )}
      {core?.status === "faulted" && failure === undefined && (
        <section className="wrong" aria-label="What went wrong">
          <h2>The program itself has an error</h2>
          <p>{core.fault?.message}</p>
          <p className="advice">Who knows RACE Pro can find the place. You can start again.</p>
        </section>
      )}
      {look === "failed" && failure === undefined && <p className="wrong is-short">{isBadOutcome(core?.outcome) ? `It ended at “${core?.outcome ?? ""}”.` : ""}</p>}
      <Asked />
      <RunButtons name={name} />
      <ModeHere />
      <Finished name={name} />
    </main>
  );
}

function statusOf(look: string): string {
  const texts: Readonly<Record<string, string>> = { ready: "Not started", running: "Running", paused: "Paused", interrupted: "Interrupted: it waits until you let it go on", ended: "Done", failed: "Stopped by an error", faulted: "Stopped by an error", aborted: "Stopped" };
  return texts[look] ?? look;
}

const endOf = (look: string): string => (look === "ended" ? "All done" : look === "aborted" ? "It was stopped" : "Something went wrong");

function Headline({ title, icon }: { readonly title: string; readonly icon: string | undefined }) {
  return (
    <h1>
      {icon !== undefined && <Picture name={icon} />}
      <span>{title}</span>
    </h1>
  );
}

/** The steps of the time line that is gone along: done, now, still to come. */
function Steps({ progress: { line, now, done } }: { readonly progress: Progress }) {
  const steps = (line?.steps ?? []).filter(({ disabled }) => !disabled);
  const current = now.at(-1)?.id;
  return (
    <ol className="progress" aria-label={`Step ${Math.min(done + 1, steps.length)} of ${steps.length}`}>
      {steps.map(({ id, title }, i) => (
        <li key={id} className={id === current ? "is-now" : i < done ? "is-done" : ""} aria-current={id === current ? "step" : undefined}>
          <span>{title}</span>
        </li>
      ))}
    </ol>
  );
}
