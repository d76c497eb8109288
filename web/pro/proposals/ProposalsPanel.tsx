// Proposed changes of documents, over the page: those that wait for somebody who decides, and the one that is chosen. Closed with Esc.
import { useState, type KeyboardEvent } from "react";
import type { Proposal } from "../../generated/messages";
import { proposerText, subjectText } from "../../shared/proposals/texts";
import { timeText } from "../../shared/timeText";
import { useModal } from "../../page/useModal";
import { useSession } from "../client";
import { showProposals, useProposals } from "./proposals";
import { ProposalView } from "./ProposalView";

export function ProposalsPanel() {
  const shown = useProposals((known) => known.shown);
  return shown === undefined ? null : <Panel chosen={shown.id} />;
}

const close = () => showProposals(undefined);

/** The arrows go through the list. */
function moveByArrow(event: KeyboardEvent<HTMLElement>): void {
  const rows = [...event.currentTarget.querySelectorAll<HTMLElement>(".proposal-row")];
  const at = rows.findIndex((row) => row === document.activeElement);
  const next = at < 0 ? undefined : { ArrowDown: rows[at + 1], ArrowUp: rows[at - 1], Home: rows[0], End: rows.at(-1) }[event.key];
  if (next === undefined) return;
  event.preventDefault();
  next.focus();
}

function Panel({ chosen }: { readonly chosen: string | undefined }) {
  const dialog = useModal();
  const [now] = useState(() => Date.now());
  const undecided = useProposals((known) => known.undecided);
  const offline = useSession((s) => s.connection !== "open");
  return (
    <dialog ref={dialog} className="documents proposals" aria-label="Proposals" onClose={close} onClick={(event) => event.target === event.currentTarget && close()}>
      <div className="documents-body">
        <div className="documents-head">
          <h2>Proposals</h2>
          <button type="button" aria-label="Close" onClick={close}>
            ✕
          </button>
        </div>
        {offline && <p className="documents-offline">The server is not there: nothing can be decided until it answers again.</p>}
        {undecided.length === 0 && <p className="documents-none">No proposal waits for a decision.</p>}
        <ul className="proposal-list" aria-label="Proposals that wait" onKeyDown={moveByArrow}>
          {undecided.map((proposal) => (
            <li key={proposal.id}>
              <Row proposal={proposal} isChosen={proposal.id === chosen} now={now} />
            </li>
          ))}
        </ul>
        {chosen !== undefined && <ProposalView key={chosen} id={chosen} offline={offline} />}
      </div>
    </dialog>
  );
}

interface RowProps {
  readonly proposal: Proposal;
  readonly isChosen: boolean;
  /** In ms since 1970. */
  readonly now: number;
}

function Row({ proposal, isChosen, now }: RowProps) {
  const { id, note, created, status } = proposal;
  return (
    <button type="button" className="proposal-row" aria-pressed={isChosen} onClick={() => showProposals({ id: isChosen ? undefined : id })}>
      <b>{subjectText(proposal)}</b>
      <span>{note}</span>
      <small>
        {proposerText(proposal)}, <time dateTime={new Date(created).toISOString()}>{timeText(created, now)}</time>
        {status === "outdated" && <em> · outdated</em>}
      </small>
    </button>
  );
}
