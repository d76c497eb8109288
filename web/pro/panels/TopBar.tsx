// Top bar: the watched run, a new run, the tabs, the state of the connection, the theme, and the help.
import { useMemo, useState } from "react";
import { statusText } from "../../shared/run/controls";
import { lastStatusText } from "../../shared/run/lostText";
import { interruptedElsewhere, isInterrupted } from "../../shared/run/interruption";
import { errorsText } from "../../shared/run/errorsText";
import { documentText, errorCount, refusalToStart } from "../../shared/session/draft";
import { keysOf } from "../../shared/session/shortcuts";
import { isStored } from "../../shared/session/session";
import type { Page } from "../../shared/session/view";
import { openDocument, useEditing } from "../edit/editing";
import { attempt, useCore, useSession, useView, view, watch } from "../client";
import { showHelp } from "../help/help";
import { ThemeButton } from "../theme/ThemeButton";
import { LoadRun } from "../documents/LoadRun";
import { ProposalsButton } from "../proposals/ProposalsButton";
import { openRun, showRuns } from "../runs/actions";
import { AccountButton } from "../login/AccountButton";
import { Icon } from "./Icon";
import { counted } from "../../shared/counted";
import { holderText, kModeMeans, modeName, modeText } from "../../shared/control/texts";
import { useStop } from "../../stop/useStop";

const pages: readonly { readonly page: Page; readonly name: string }[] = [
  { page: "task", name: "Task" },
  { page: "services", name: "Services" },
  { page: "cell", name: "Cell" },
];

/** Id of the text that says why a document cannot be started. */
const kRefusal = "start-refusal";

export function TopBar() {
  return (
    <header className="topbar">
      <div className="brand">
        <svg viewBox="0 0 32 32" aria-hidden="true">
          <rect x="4" y="6" width="16" height="20" rx="5" fill="none" stroke="currentColor" strokeWidth="2.4" />
          <rect x="15" y="12.5" width="13" height="7" rx="1" fill="var(--fired)" stroke="currentColor" strokeWidth="1.6" />
        </svg>
        <h1>RACE</h1>
        <span>Pro</span>
      </div>
      <CoreChoice />
      <InterruptedElsewhere />
      <NewRun />
      <DocumentsButton />
      <button type="button" className="documents-button" title={`The runs that the server has stored (${keysOf("runs")})`} aria-keyshortcuts={keysOf("runs").replace("Ctrl", "Control")} onClick={() => showRuns(true)}>
        Runs
      </button>
      <ProposalsButton />
      <PageTabs />
      <ModeButton />
      <ConnectionLight />
      <AccountButton />
      <ThemeButton />
      <GuideButton />
      <HelpButton />
    </header>
  );
}

function CoreChoice() {
  const cores = useSession((s) => s.cores);
  const watched = useSession((s) => s.watched);
  const lost = useSession((s) => s.connection === "lost");
  const core = useCore();
  const stored = useSession((s) => (isStored(s) ? s.stored : undefined));
  return (
    <label className="field">
      <span>Run</span>
      <select aria-label="Watched run" className={core !== undefined && isInterrupted(core) ? "is-interrupted" : ""} value={watched ?? ""} onChange={(event) => watch(event.target.value)}>
        {watched === undefined && <option value="">none</option>}
        {stored !== undefined && (
          <option value={stored.id}>
            {stored.document} · {stored.id} · {statusText(stored)}, stored
          </option>
        )}
        {cores.map((core) => (
          <option key={core.id} value={core.id}>
            {core.document} · {core.id} · {lost ? lastStatusText(core) : statusText(core)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** Interrupted runs besides the watched one: a click shows the newest. */
function InterruptedElsewhere() {
  const cores = useSession((s) => s.cores);
  const watched = useSession((s) => s.watched);
  const core = useCore();
  const interrupted = useMemo(() => interruptedElsewhere(cores, watched), [cores, watched]);
  const [first] = interrupted;
  if (first === undefined) return null;
  const more = core !== undefined && isInterrupted(core);
  return (
    <button type="button" className="interrupted-elsewhere" title={`Show run ${first.id}`} onClick={() => void attempt(() => openRun(first.id))}>
      <Icon name="interrupted" />
      {interrupted.length} {more ? "more " : ""}interrupted
    </button>
  );
}

function NewRun() {
  const documents = useSession((s) => s.documents);
  const [chosen, setChosen] = useState<string>();
  const document = documents.find(({ name }) => name === chosen) ?? documents.find((entry) => errorCount(entry) === 0) ?? documents[0];
  const refusal = document === undefined ? undefined : refusalToStart(document);
  const lost = useSession((s) => s.connection === "lost");
  return (
    <div className="field new-run">
      <span>New</span>
      <select aria-label="Document" value={document?.name ?? ""} onChange={(event) => setChosen(event.target.value)} disabled={documents.length === 0}>
        {documents.map((entry) => (
          <option key={entry.name} value={entry.name}>
            {documentText(entry)}
          </option>
        ))}
      </select>
      <LoadRun key={document?.name} document={document?.name} refusal={refusal} refusalId={kRefusal} offline={lost} />
      <button type="button" disabled={document === undefined || lost} onClick={() => document !== undefined && openDocument(document.name)}>
        Edit
      </button>
      {document !== undefined && refusal !== undefined && (
        <>
          <span id={kRefusal} className="unseen">
            {refusal}
          </span>
          <button type="button" className="show-errors" onClick={() => openDocument(document.name)}>
            Show {errorsText(errorCount(document))}
          </button>
        </>
      )}
    </div>
  );
}

function DocumentsButton() {
  return (
    <button
      type="button"
      className="documents-button"
      title={`New, open, upload, download, duplicate, delete (${keysOf("documents")})`}
      aria-keyshortcuts={keysOf("documents").replace("Ctrl", "Control")}
      onClick={() => view.dispatch({ type: "documents", shown: true })}
    >
      Documents
    </button>
  );
}

function PageTabs() {
  const page = useView((v) => v.page);
  const hasCell = useSession((s) => s.cell);
  const edited = useEditing((now) => now.document);
  const broken = useSession((s) => s.services.reduce((sum, service) => sum + service.violations.length, 0));
  return (
    <div className="tabs" role="tablist" aria-label="Pages">
      {(edited === undefined ? pages : [{ page: "edit", name: "Edit" } as const, ...pages]).map((entry) => (
        <button
          key={entry.page}
          type="button"
          role="tab"
          disabled={entry.page === "cell" && !hasCell}
          aria-selected={page === entry.page}
          onClick={() => view.dispatch({ type: "page", page: entry.page })}
        >
          {entry.name}
          {entry.page === "services" && broken > 0 && <span className="count" aria-label={counted(broken, "violation")}>{broken}</span>}
        </button>
      ))}
    </div>
  );
}

/** Always says the mode; leads to what is moved by hand, and to the controls. */
function ModeButton() {
  const mode = useStop((stop) => stop.mode);
  const text = useStop((stop) => (stop.mode === undefined ? "" : `${modeText(stop.mode)}. ${kModeMeans[stop.mode]} ${holderText(stop.holder, stop.held)}`));
  const shown = useView((v) => v.drawer === "manual");
  if (mode === undefined) return null;
  return (
    <button type="button" className={`mode-button is-${mode}`} aria-pressed={shown} aria-label={`${modeName(mode)} mode`} title={`${text}: take them, set the mode, move by hand`} onClick={() => view.dispatch({ type: "drawer", drawer: shown ? "closed" : "manual" })}>
      {modeName(mode)}
    </button>
  );
}

function GuideButton() {
  return (
    <button type="button" className="guide-button" title={`Tour, concepts, function language, error codes (${keysOf("guide")})`} aria-keyshortcuts={keysOf("guide")} onClick={() => showHelp({ topic: "start" })}>
      Help
    </button>
  );
}

function HelpButton() {
  return (
    <button type="button" className="help-button" aria-label="Keys and mouse" title={`Keys and mouse (${keysOf("help")})`} onClick={() => view.dispatch({ type: "help", shown: true })}>
      ?
    </button>
  );
}

function ConnectionLight() {
  const connection = useSession((s) => s.connection);
  const text = { connecting: "Connecting", open: "Connected", lost: "Connection lost" }[connection];
  return (
    <div className={`connection is-${connection}`} role="status" title={text}>
      {text}
    </div>
  );
}
