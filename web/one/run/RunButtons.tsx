// Begins, holds and ends the run.
import { isSamePress, makeOnce, useIsMaking } from "../../page/starting";
import { allowed, type Command } from "../../shared/run/controls";
import { api, attempt, useCore, useRefusalOfCommand, useSession } from "../client";
import { useEditing } from "../editing";
import { useProblems, useUntaught } from "../model";
import { go } from "../place";
import { select } from "../select";
import { UntaughtPose } from "../step/Untaught";
import { texts } from "../texts";
import { begin } from "./begin";

const t = texts.runView;

export function RunButtons({ name }: { readonly name: string }) {
  const core = useCore();
  const lost = useSession((s) => s.connection !== "open");
  const problems = useProblems();
  const errors = useEditing((now) => now.session?.errors.length ?? 0);
  const commands = allowed(core);
  const isNew = core === undefined || commands.has("again");
  const [problem] = problems;
  const [untaught] = useUntaught();
  const notReady = !isNew || (problem === undefined && errors === 0) ? undefined : (problem?.text ?? t.hasErrors);
  const starting = useIsMaking();
  const run = (command: "start" | "pause" | "resume" | "stop") => attempt(async () => core !== undefined && (await api[command](core.id)));
  const startOnce = (act: () => Promise<void>) => void makeOnce(act);
  return (
    <section className="run-buttons" aria-label={t.buttons}>
      {isNew && <RunButton command="again" name={core === undefined ? t.start : t.startAgain} isMain disabled={lost || starting || notReady !== undefined} act={() => startOnce(() => attempt(() => begin(name)))} />}
      {commands.has("start") && <RunButton command="start" name={t.start} isMain disabled={lost || starting} act={() => startOnce(() => run("start"))} />}
      {commands.has("resume") && <RunButton command="resume" name={t.goOn} isMain disabled={lost || starting} act={() => startOnce(() => run("resume"))} />}
      {commands.has("pause") && <RunButton command="pause" name={t.pause} hint={t.pauseHint} disabled={lost} act={() => isSamePress() || void run("pause")} />}
      {commands.has("stop") && <RunButton command="stop" name={t.end} hint={t.endHint} disabled={lost} act={() => void run("stop")} />}
      {isNew && untaught !== undefined && <UntaughtPose untaught={untaught} />}
      {notReady !== undefined && (
        <p>
          {t.incomplete(notReady)}{" "}
          <button
            type="button"
            className="link"
            onClick={() => {
              go({ view: "build" });
              if (problem !== undefined) select(problem.step);
            }}
          >
            {t.showIt}
          </button>
        </p>
      )}
    </section>
  );
}

interface ButtonProps {
  readonly command: Command;
  readonly name: string;
  readonly hint?: string;
  readonly isMain?: boolean;
  readonly disabled: boolean;
  readonly act: () => void;
}

function RunButton({ command, name, hint, isMain = false, disabled, act }: ButtonProps) {
  const refusal = useRefusalOfCommand(command);
  return (
    <>
      <button type="button" className={isMain ? "main" : ""} disabled={disabled || refusal !== undefined} title={refusal ?? hint} onClick={act}>
        {name}
      </button>
      {refusal !== undefined && isMain && <p>{t.notNow(refusal)}</p>}
    </>
  );
}
