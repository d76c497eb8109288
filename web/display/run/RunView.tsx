// Tasks: the run that is shown, how fast the robot goes, other runs, and what can be started.
import { ModeSwitch } from "../../control/ModeSwitch";
import { SpeedOverride } from "../../control/SpeedOverride";
import { isOver, statusLook, statusText } from "../../shared/run/controls";
import { watchedCore } from "../../shared/session/session";
import { wordsOf } from "../../shared/pendant/activity";
import { fetchWithControls, problem, robotSpeed, useRefusal, useSession, watch } from "../client";
import { texts } from "../texts";
import { RunCard } from "./RunCard";
import { StartList } from "./StartList";

export function RunView() {
  const core = useSession(watchedCore);
  const [mode, speed] = [useRefusal("set_mode"), useRefusal("set_speed")];
  return (
    <div className="run">
      {core === undefined ? <p className="empty">{texts.run.none}</p> : <RunCard core={core} />}
      <SpeedOverride speed={robotSpeed} refusal={speed} />
      <OtherRuns />
      <StartList />
      <section aria-label={texts.run.mode}>
        <h2>{texts.run.modeTitle}</h2>
        <ModeSwitch refusal={mode} fetcher={fetchWithControls} onProblem={problem} />
        {mode !== undefined && <p className="soft">{texts.run.modeRefused(mode)}</p>}
      </section>
    </div>
  );
}

/** Runs that are not over, besides the one that is shown. */
function OtherRuns() {
  const cores = useSession((now) => now.cores);
  const watched = useSession((now) => now.watched);
  const others = cores.filter((core) => core.id !== watched && !isOver(core));
  if (others.length === 0) return null;
  return (
    <section aria-label={texts.run.others}>
      <h2>{texts.run.others}</h2>
      <ul className="runs">
        {others.map((core) => (
          <li key={core.id}>
            <button type="button" className="plain" data-status={statusLook(core)} onClick={() => watch(core.id)}>
              <b>{wordsOf(core.document)}</b> <span>{statusText(core)}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
