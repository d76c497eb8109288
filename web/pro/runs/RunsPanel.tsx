// The stored runs, over the page: opened with the button of the top bar or by its address, closed with Esc.
import { useEffect, useMemo, useRef, useState } from "react";
import { useModal } from "../../page/useModal";
import { countText, matchingRuns, type Outcome } from "../../shared/runs/list";
import { useSession, useView } from "../client";
import { useAttempt } from "../documents/useAttempt";
import { showRuns } from "./actions";
import { RunRow } from "./RunRow";
import { loadOlder, loadRuns, useRuns } from "./runs";
import { counted } from "../../shared/counted";

export function RunsPanel() {
  const shown = useView((v) => v.runs);
  return shown ? <Panel /> : null;
}

const close = () => showRuns(false);

const kOutcomes: readonly { readonly outcome: Outcome; readonly name: string }[] = [
  { outcome: "good", name: "Ended" },
  { outcome: "bad", name: "Failed, faulted or stopped" },
  { outcome: "open", name: "Running" },
  { outcome: "waits", name: "Interrupted" },
  { outcome: "ready", name: "Not started" },
];

function Panel() {
  const dialog = useModal();
  const [document, setDocument] = useState<string>();
  const [outcome, setOutcome] = useState<Outcome>();
  const [text, setText] = useState("");
  const { attempt, reason, busy } = useAttempt();
  const offline = useSession((s) => s.connection !== "open");
  const documents = useSession((s) => s.documents);
  const list = useRuns();
  const found = useMemo(() => matchingRuns(list.runs, { text, outcome }), [list, text, outcome]);
  const load = useRef(attempt);
  useEffect(() => {
    if (!offline) void load.current(() => loadRuns(document));
  }, [document, offline]);
  return (
    <dialog ref={dialog} className="documents runs" aria-label="Runs" onClose={close} onClick={(event) => event.target === event.currentTarget && close()}>
      <div className="documents-body">
        <div className="documents-head">
          <h2>Runs</h2>
          <button type="button" aria-label="Close" onClick={close}>
            ✕
          </button>
        </div>
        <div className="runs-tools" role="search" aria-label="Runs">
          <input type="search" data-first placeholder="Number, document, outcome, argument" aria-label="Search the runs" value={text} onChange={(event) => setText(event.target.value)} />
          <select aria-label="Of the document" value={document ?? ""} onChange={(event) => setDocument(event.target.value === "" ? undefined : event.target.value)}>
            <option value="">Any document</option>
            {documents.map(({ name }) => (
              <option key={name}>{name}</option>
            ))}
          </select>
          <select aria-label="With the outcome" value={outcome ?? ""} onChange={(event) => setOutcome(kOutcomes.find((each) => each.outcome === event.target.value)?.outcome)}>
            <option value="">Any outcome</option>
            {kOutcomes.map((each) => (
              <option key={each.outcome} value={each.outcome}>
                {each.name}
              </option>
            ))}
          </select>
          <button type="button" disabled={offline || busy} onClick={() => void attempt(() => loadRuns(document))}>
            Reload
          </button>
        </div>
        {offline && <p className="documents-offline">The server is not there: nothing can be opened or deleted until it answers again.</p>}
        {reason !== undefined && (
          <p className="bad" role="alert">
            {reason}
          </p>
        )}
        <p className="quiet" role="status" aria-label="Found">
          {countText(found.length, list)}
        </p>
        <p className="quiet">
          The server removes the oldest runs that are over when they are more than its settings <code>keep_runs</code> or <code>keep_mb</code> allow.
        </p>
        <ul className="document-list" aria-label="Stored runs">
          {found.map((run) => (
            <RunRow key={run.id} run={run} offline={offline} />
          ))}
        </ul>
        {found.length === 0 && !busy && <p className="documents-none">{list.runs.length === 0 ? "No run is stored yet. Start one with Load and F5, or drop the file of a run here." : "No run that is loaded is like that."}</p>}
        {list.damaged.length > 0 && <p className="bad">{counted(list.damaged.length, "run is", "runs are")} damaged and cannot be listed.</p>}
        {list.next !== undefined && (
          <button type="button" className="runs-older" disabled={offline || busy} onClick={() => void attempt(() => loadOlder(document))}>
            Load older runs
          </button>
        )}
      </div>
    </dialog>
  );
}
