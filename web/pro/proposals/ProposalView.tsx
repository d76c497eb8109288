// One proposal: why it was made, what it would change, and what can be done with it; also one that somebody has decided about meanwhile.
import { useEffect, useState } from "react";
import type { Proposal } from "../../generated/messages";
import { isUndecided } from "../../shared/proposals/proposals";
import { kNoNote, outdatedText, proposerText, statusText, subjectText } from "../../shared/proposals/texts";
import { api } from "../client";
import { messageOf } from "../../shared/messageOf";
import { Decision } from "./Decision";
import { useProposals } from "./proposals";
import { ProposedChanges } from "./ProposedChanges";

interface Props {
  readonly id: string;
  /** Nothing can be done: the server is not there. */
  readonly offline: boolean;
}

/** The proposal with its document, or why it cannot be had. */
type Loaded = { readonly proposal: Proposal } | { readonly failure: string };

/** Loaded again when it has another status. */
function useLoaded(id: string, offline: boolean): Loaded | undefined {
  const told = useProposals((known) => known.undecided.find((each) => each.id === id)?.status);
  const [loaded, setLoaded] = useState<Loaded>();
  useEffect(() => {
    if (offline) return undefined;
    let isLast = true;
    const take = (found: Loaded) => isLast && setLoaded(found);
    api.proposal(id).then((proposal) => take({ proposal }), (error: unknown) => take({ failure: messageOf(error) }));
    return () => {
      isLast = false;
    };
  }, [id, told, offline]);
  return loaded;
}

export function ProposalView({ id, offline }: Props) {
  const loaded = useLoaded(id, offline);
  if (loaded === undefined) return <p className="quiet">Loading…</p>;
  if ("failure" in loaded)
    return (
      <p className="bad" role="alert">
        The proposal cannot be shown: {loaded.failure}
      </p>
    );
  return <Whole proposal={loaded.proposal} offline={offline} />;
}

/** The button that has decided is gone. */
function focusIfLost(element: HTMLElement | null): void {
  if (element !== null && (document.activeElement === null || document.activeElement === document.body)) element.focus();
}

function Whole({ proposal, offline }: { readonly proposal: Proposal; readonly offline: boolean }) {
  const { note, status } = proposal;
  return (
    <section className="proposal" aria-label={`Proposal for ${proposal.document}`}>
      <h3>{subjectText(proposal)}</h3>
      <p className="quiet">proposed by {proposerText(proposal)}</p>
      <p className="proposal-note">{note === "" ? kNoNote : note}</p>
      {status === "outdated" && (
        <p className="proposal-outdated" role="status">
          {outdatedText(proposal)}
        </p>
      )}
      {!isUndecided(proposal) && (
        <p ref={focusIfLost} tabIndex={-1} className="proposal-decided" role="status">
          It is {statusText(proposal)}.
        </p>
      )}
      <ProposedChanges proposal={proposal} />
      {isUndecided(proposal) && <Decision proposal={proposal} offline={offline} />}
    </section>
  );
}
