// Another process of the server answers than before: what became of the runs, each a way to it.
import { interruptedByRestart, restartText } from "../../shared/run/interruption";
import { attempt, session, useSession } from "../client";
import { openRun } from "../runs/actions";

/** So many runs are named; all of them are in the list of runs. */
const kMostNamed = 5;

export function RestartedServer() {
  const restarted = useSession((s) => s.restarted && s.connection !== "lost");
  const cores = useSession((s) => s.cores);
  const watched = useSession((s) => s.watched);
  if (!restarted) return null;
  const interrupted = interruptedByRestart(cores);
  return (
    <div className="restarted-server" role="status" aria-label="Server restarted">
      <strong>Server restarted</strong>
      <span>{restartText(interrupted)}</span>
      {interrupted.slice(0, kMostNamed).map(({ id, document }) => (
        <button key={id} type="button" className="link" aria-current={id === watched ? "true" : undefined} onClick={() => void attempt(() => openRun(id))}>
          Run {id} of {document}
          {id === watched ? ", shown" : ""}
        </button>
      ))}
      {interrupted.length > kMostNamed && <span>and {interrupted.length - kMostNamed} more, in the list of runs</span>}
      <button type="button" aria-label="Dismiss" onClick={() => session.dispatch({ type: "restart_seen" })}>
        ✕
      </button>
    </div>
  );
}
