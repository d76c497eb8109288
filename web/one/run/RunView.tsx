// The run of the application: what happens now, what is next, what went wrong, and the buttons to begin, hold and end it.
import { useEffect, useMemo, useState } from "react";
import { SpeedOverride } from "../../control/SpeedOverride";
import { isBadOutcome, isHeld, isOver, statusLook } from "../../shared/run/controls";
import { activeIds, kNoProgress, progressIn, type Progress } from "../../shared/timeline/progress";
import { failureText } from "../line/StepCard";
import { robotSpeed, useCore, useRefusal, useSession } from "../client";
import { useApplication } from "../model";
import { Picture } from "../Picture";
import { Asked } from "./Asked";
import { becomeDisplay, useDisplay } from "./display";
import { treeOfRun, useFailures } from "./failed";
import { Finished } from "./Finished";
import { Past } from "./Past";
import { modeBefore, type ModeBefore } from "./hold";
import { ModeHere } from "./ModeHere";
import { Rounds } from "./Rounds";
import { useRounds } from "./rounds";
import { RunButtons } from "./RunButtons";
import { useRetry } from "./retry";
import { TeachAgain, TeachButtons } from "./TeachAgain";
import { texts } from "../texts";

const t = texts.runView;

export function RunView({ name }: { readonly name: string }) {
  const application = useApplication();
  const core = useCore();
  const active = useSession((s) => s.run?.active);
  const model = useSession((s) => s.model);
  useEffect(becomeDisplay, []);
  const progress = useMemo(() => {
    const tree = treeOfRun({ model });
    return application === undefined || tree === undefined || active === undefined ? kNoProgress : progressIn(application.root, activeIds(active, tree));
  }, [application, model, active]);
  const { now: failure, past } = useFailures(application, progress);
  const tryAgain = useRetry(core, core === undefined || isOver(core) ? undefined : failure?.step.title);
  const [taught, setTaught] = useState<string>();
  const [before, setBefore] = useState<ModeBefore>();
  const asksHere = useDisplay((page) => page.content?.question !== undefined);
  const rounds = useRounds(application, progress);
  const isGoing = core !== undefined && !isOver(core) && core.status !== "ready";
  const look = core === undefined ? "ready" : statusLook(core);
  const speed = useRefusal("set_speed");
  const lost = useSession((s) => (s.connection === "open" ? undefined : texts.frame.away));
  const step = progress.now.at(-1);
  // While a step is tried again by itself, nothing is to be done.
  const isAsked = !isGoing || asksHere || core.paused;
  const pose = failure?.poses.find((each) => each === taught);
  const teach = core !== undefined && failure !== undefined && failure.poses.length > 0 && isAsked ? <TeachButtons core={core} poses={failure.poses} onOpen={setTaught} onBegin={() => setBefore(modeBefore(core, before))} /> : undefined;
  return (
    <main className={`run is-${look}`} aria-label={t.name}>
      <section className="now" aria-label={t.now}>
        <p className="status" role="status" aria-label={t.status}>
          {t.statuses[look]}
        </p>
        <Headline title={isGoing ? (step?.title ?? "…") : core !== undefined && isOver(core) ? endOf(look) : t.ready} icon={isGoing ? step?.about.icon : undefined} />
        {isGoing && progress.now.length > 1 && <p className="within">{progress.now.slice(0, -1).map(({ title }) => title).join(" › ")}</p>}
        {isGoing && <Rounds rounds={rounds} />}
        {isGoing && progress.next !== undefined && (
          <p className="next">
            {t.next} <b>{progress.next.title}</b>
          </p>
        )}
        {core !== undefined && isHeld(core) && <p className="quiet">{t.whilePaused}</p>}
        {isGoing && progress.line !== undefined && <Steps progress={progress} />}
      </section>
      {failure !== undefined && (
        <section className="wrong" aria-label={t.wrong}>
          <h2>{t.failure(failure.step.title, failure.title)}</h2>
          {failure.why !== undefined && <p>{failure.why}</p>}
          {failure.advice !== "" && <p className="advice">{failure.advice}</p>}
          {isGoing && failure.step.failure !== undefined && <p className="quiet">{t.ifItFails(failureText(failure.step.failure, failure.step.times))}</p>}
          {pose === undefined && !asksHere && teach !== undefined && <div className="buttons">{teach}</div>}
        </section>
      )}
      {core?.status === "faulted" && (
        <section className="wrong" aria-label={t.wrong}>
          <h2>{t.fault}</h2>
          <p>{core.fault?.message}</p>
          <p className="advice">{t.faultAdvice}</p>
        </section>
      )}
      {look === "failed" && failure === undefined && <p className="wrong is-short">{isBadOutcome(core?.outcome) ? t.outcome(core?.outcome ?? "") : ""}</p>}
      {pose !== undefined && core !== undefined ? <TeachAgain key={pose} name={name} core={core} pose={pose} mode={before?.mode} onGoOn={tryAgain} onClose={() => setTaught(undefined)} /> : <Asked>{teach}</Asked>}
      <RunButtons name={name} />
      <SpeedOverride speed={robotSpeed} refusal={lost ?? speed} />
      <ModeHere />
      <Past past={past} />
      <Finished name={name} />
    </main>
  );
}

const endOf = (look: string): string => (look === "ended" ? t.done : look === "aborted" ? t.stopped : t.failed);

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
    <ol className="progress" aria-label={t.progress(Math.min(done + 1, steps.length), steps.length)}>
      {steps.map(({ id, title }, i) => (
        <li key={id} className={id === current ? "is-now" : i < done ? "is-done" : ""} aria-current={id === current ? "step" : undefined}>
          <span>{title}</span>
        </li>
      ))}
    </ol>
  );
}
