// What runs and what is edited: above the drawing of the document, while there is a run of it.
import { useId, useState } from "react";
import { newestRun } from "../../shared/live/shownRun";
import { changesText, executesText, kNothingElse } from "../../shared/live/texts";
import { isOver } from "../../shared/run/controls";
import type { Core } from "../../generated/messages";
import { follow, useCore, useSession, useView, view, watch } from "../client";
import { useEditing } from "../edit/editing";
import { useRefusal } from "../login/rights";
import { DifferenceList } from "./DifferenceList";
import { useCompared, useExecuted } from "./executed";
import { useRunOfDocument } from "./shownRun";

export function LiveBar() {
  const core = useRunOfDocument();
  return core === undefined ? <OtherRun /> : <Bar core={core} />;
}

function Bar({ core }: { readonly core: Core }) {
  const revision = useEditing((now) => now.session?.confirmed?.revision);
  const shown = useView((v) => v.runShown);
  const lost = useSession((s) => s.connection === "lost");
  const refusal = useRefusal("follow_edits");
  if (revision === undefined) return null;
  return (
    <section className="live-bar" aria-label="Run of this document">
      <span className="live-text">{executesText(core, revision)}</span>
      <Changes core={core} revision={revision} />
      <span className="live-choices">
        {!isOver(core) && (
          <label className="follow" title={refusal ?? "Each edit without errors changes the run between its macro steps. A new port or action may move the robot."}>
            <input type="checkbox" checked={core.live} disabled={lost || refusal !== undefined} onChange={(event) => void follow(event.target.checked)} /> Follow edits
          </label>
        )}
        <label className="follow" title="Active states and values of the run, and what differs from it, on the drawing and in the forms">
          <input type="checkbox" checked={shown} onChange={(event) => view.dispatch({ type: "run_shown", shown: event.target.checked })} /> Show the run
        </label>
      </span>
    </section>
  );
}

/** How many changes the run does not execute; a click lists them. */
function Changes({ core, revision }: { readonly core: Core; readonly revision: number }) {
  const [isOpen, setOpen] = useState(false);
  const listId = useId();
  const executed = useExecuted();
  const compared = useCompared();
  if (executed !== undefined && "reason" in executed) return <span className="quiet">Revision {core.revision} cannot be compared: {executed.reason}</span>;
  if (compared === undefined) return null;
  const { rows } = compared;
  if (rows.length === 0) return core.revision === revision ? null : <span className="quiet">{kNothingElse}</span>;
  return (
    <>
      <button type="button" className="live-changes" aria-expanded={isOpen} aria-controls={listId} onClick={() => setOpen(!isOpen)}>
        {changesText(rows.length)} {isOpen ? "▴" : "▾"}
      </button>
      <div id={listId} hidden={!isOpen} className="live-list">
        {isOpen && <DifferenceList compared={compared} label="Changes that the run does not execute" />}
      </div>
    </>
  );
}

/** The watched run is of another document; one of this document can be watched instead. */
function OtherRun() {
  const document = useEditing((now) => now.document);
  const watched = useCore();
  const run = useSession((now) => (document === undefined ? undefined : newestRun(now.cores, document)));
  if (run === undefined) return null;
  return (
    <section className="live-bar" aria-label="Run of this document">
      <span className="live-text">{watched === undefined ? "No run is watched." : `You watch run ${watched.id} of ${watched.document}, which is not shown here.`}</span>
      <button type="button" className="live-changes" onClick={() => watch(run.id)}>
        Show run {run.id} of this document
      </button>
    </section>
  );
}
