// The run that is shown: what it does now, and what can be done with it.
import type { Core } from "../../generated/messages";
import { useIsMaking } from "../../page/starting";
import { activityOf, wordsOf } from "../../shared/pendant/activity";
import { allowed, isHeld, isOver, primary, statusLook, statusText, type Command } from "../../shared/run/controls";
import { interruptionText } from "../../shared/run/interruption";
import { useRefusalOfCommand, useRefusalToStart, useSession } from "../client";
import { texts } from "../texts";
import { run } from "./runs";

const kNames = texts.run.commands;
type Shown = keyof typeof kNames;

export function RunCard({ core }: { readonly core: Core }) {
  const active = useSession((now) => now.run);
  const activity = active === undefined || isOver(core) ? undefined : activityOf(active);
  const commands = allowed(core);
  const first = primary(core);
  const shown: readonly Shown[] = [...(first === "start" || first === "resume" || first === "again" ? [first] : []), ...(["pause", "stop"] as const).filter((each) => commands.has(each))];
  return (
    <section className="run-card" aria-label={texts.run.name(core.document)} data-status={statusLook(core)}>
      <h2>{wordsOf(core.document)}</h2>
      <p className="run-status" role="status">
        {statusText(core)}
      </p>
      {activity !== undefined && (
        <p className="run-now">
          {activity.within.length > 0 && <small>{activity.within.join(" › ")}</small>}
          <strong>{activity.now}</strong>
          {activity.others > 0 && <small>{texts.run.beside(activity.others)}</small>}
        </p>
      )}
      <Why core={core} />
      <div className="run-buttons">
        {shown.map((command) => (
          <CommandButton key={command} command={command} isFirst={command === first} />
        ))}
      </div>
    </section>
  );
}

/** Why it stands, in words. */
function Why({ core }: { readonly core: Core }) {
  const interrupted = interruptionText(core);
  if (interrupted !== undefined) return <p className="soft">{interrupted.happened ?? interrupted.title}</p>;
  if (core.status === "faulted") return <p className="is-bad">{core.fault?.message}</p>;
  return isHeld(core) ? <p className="soft">{texts.run.whilePaused}</p> : null;
}

function CommandButton({ command, isFirst }: { readonly command: Shown; readonly isFirst: boolean }) {
  const ofCommand = useRefusalOfCommand(command satisfies Command);
  const toStart = useRefusalToStart();
  const refusal = command === "again" ? toStart : ofCommand;
  const starting = useIsMaking() && command !== "pause" && command !== "stop";
  return (
    <>
      <button type="button" className={isFirst ? "choice" : "plain"} disabled={starting || refusal !== undefined} title={refusal} onClick={() => run(command)}>
        {kNames[command]}
      </button>
      {refusal !== undefined && <small className="soft">{texts.run.refused(kNames[command], refusal)}</small>}
    </>
  );
}
