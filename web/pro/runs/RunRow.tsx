// A stored run in the list, with what can be done with it.
import { useState } from "react";
import type { Run } from "../../generated/messages";
import { coreOfRun } from "../../shared/runs/storedRun";
import { outcomeText, runTime } from "../../shared/runs/texts";
import { isOver, statusLook, statusText } from "../../shared/run/controls";
import { api, useSession } from "../client";
import { useAttempt } from "../documents/useAttempt";
import { useRefusal } from "../login/rights";
import { openRun } from "./actions";
import { CompareRun } from "./CompareRun";
import { MakeTestButton, SavedTest } from "./MakeTest";
import { ExportRun } from "./ExportRun";
import { removeRun } from "./runs";
import { counted } from "../../shared/counted";

const kDate = new Intl.DateTimeFormat(undefined, { dateStyle: "medium", timeStyle: "medium" });

const kExportTitle = "For Foxglove: frames, joints, pictures, state, calls and derivations, as far as they are recorded";

interface Props {
  readonly run: Run;
  /** Nothing can be done: the server is not there. */
  readonly offline: boolean;
}

export function RunRow({ run, offline }: Props) {
  const { id, document, revision, steps, created, imported } = run;
  const [asked, ask] = useState(false);
  const [compared, compare] = useState(false);
  const [saved, setSaved] = useState(false);
  const [exported, exportIt] = useState(false);
  const other = useSession((s) => (s.watched === id ? undefined : s.watched));
  const { attempt, reason, busy } = useAttempt();
  const hosted = useSession((s) => s.cores.find((core) => core.id === id));
  const disabled = offline || busy;
  const held = hosted !== undefined && !isOver(hosted);
  const took = runTime(run);
  const refusal = useRefusal("delete_run");
  return (
    <li className="document-row" aria-label={`Run ${id}`}>
      <div className="document-head">
        <button type="button" className="document-name" disabled={disabled} onClick={() => void attempt(() => openRun(id))}>
          Run {id} of {document}
        </button>
        <span className={`pill is-${statusLook(hosted ?? coreOfRun(run))}`}>{hosted === undefined ? outcomeText(run) : statusText(hosted)}</span>
        <small>
          revision {revision} · <time dateTime={new Date(created).toISOString()}>{kDate.format(created)}</time>
          {took === undefined ? "" : ` · ${took}`} · {counted(steps, "step")}
          {imported ? " · from a file" : hosted === undefined ? "" : " · hosted by a core"}
        </small>
      </div>
      <div className="document-actions">
        {other !== undefined && (
          <button type="button" disabled={disabled} aria-expanded={compared} title={`With run ${other}, which is shown`} onClick={() => compare(!compared)}>
            Compare
          </button>
        )}
        <a className="button" href={api.runFileAddress(id)} download aria-disabled={offline} title="All of the run in one file, which any server opens">
          Download
        </a>
        <MakeTestButton id={id} document={document} disabled={disabled} attempt={attempt} onSaved={setSaved} />
        <button type="button" disabled={disabled || exported || steps === 0} title={steps === 0 ? "It has no macro step" : kExportTitle} onClick={() => exportIt(true)}>
          Export MCAP
        </button>
        <button type="button" disabled={disabled || held || refusal !== undefined} title={refusal ?? (held ? "Its core is not over: stop it first" : undefined)} aria-expanded={asked} onClick={() => ask(!asked)}>
          Delete
        </button>
      </div>
      {saved && <SavedTest document={document} />}
      {compared && other !== undefined && <CompareRun id={id} other={other} />}
      {exported && <ExportRun id={id} close={() => exportIt(false)} />}
      {asked && (
        <div className="ask-delete" role="group" aria-label={`Delete run ${id}?`}>
          <span>Delete run {id}, with its journal{hosted === undefined ? "" : " and its core"}? It cannot be taken back.</span>
          <button type="button" className="danger" disabled={disabled} onClick={() => void attempt(() => removeRun(id))}>
            Delete run {id}
          </button>
          <button type="button" autoFocus onClick={() => ask(false)}>
            Keep it
          </button>
        </div>
      )}
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </li>
  );
}
