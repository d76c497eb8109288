// Left of the drawing: the history of the document, and what is compared of it.
import { useEffect, useRef, type KeyboardEvent } from "react";
import { useView } from "../client";
import { Comparison } from "./Comparison";
import { showHistory, useHistory } from "./history";
import { RevisionList } from "./RevisionList";

/** The arrows go through the revisions. */
function press(event: KeyboardEvent<HTMLElement>): void {
  const rows = [...event.currentTarget.querySelectorAll<HTMLElement>(".revision-row")];
  const at = rows.findIndex((row) => row === document.activeElement);
  const next = at < 0 ? undefined : { ArrowDown: rows[at + 1], ArrowUp: rows[at - 1], Home: rows[0], End: rows.at(-1) }[event.key];
  if (event.key === "Escape") showHistory(false);
  else if (next !== undefined) next.focus();
  else return;
  event.preventDefault();
  event.stopPropagation();
}

export function VersionsPanel() {
  const heading = useRef<HTMLHeadingElement>(null);
  const page = useView((v) => v.page);
  useEffect(() => heading.current?.focus({ preventScroll: true }), []);
  const range = useHistory((now) => now.range);
  if (page !== "edit") return null;
  return (
    <section className="versions" aria-label="History" onKeyDown={press}>
      <header>
        <h2 ref={heading} tabIndex={-1}>
          History
        </h2>
        <button type="button" aria-label="Close the history" title="Close (Esc)" onClick={() => showHistory(false)}>
          ✕
        </button>
      </header>
      {range === undefined ? <p className="quiet pad">Choose a revision to see what has changed since, also in the drawing; then restore it, or branch from it.</p> : <Comparison range={range} />}
      <RevisionList />
    </section>
  );
}
