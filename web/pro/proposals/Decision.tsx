// What is done with a proposal: accept it, decline it with a reason, look at its document; who has made it withdraws it.
import { useState } from "react";
import type { Proposal } from "../../generated/messages";
import { nameOfAuthor } from "../../shared/presence/names";
import { useLogin, useSession } from "../client";
import { edit } from "../documents/actions";
import { useAttempt } from "../documents/useAttempt";
import { useRefusal } from "../login/rights";
import { compareRange, showHistory } from "../versions/history";
import { accept, decline, showProposals, withdraw } from "./proposals";

interface Props {
  readonly proposal: Proposal;
  readonly offline: boolean;
}

/** As the server bounds it [characters]. */
const kMaxReason = 2000;

/** Shows the document as it is; `since` a revision, with what has changed. */
function show(document: string, since: number | undefined): void {
  showProposals(undefined);
  edit(document);
  if (since === undefined) return;
  showHistory(true);
  compareRange({ from: since, to: undefined });
}

export function Decision({ proposal, offline }: Props) {
  const { document, author, status, base_revision: base } = proposal;
  const [asked, ask] = useState(false);
  const { attempt, reason, busy } = useAttempt();
  const [mayAccept, mayDecline, mayWithdraw] = [useRefusal("accept_proposal"), useRefusal("decline_proposal"), useRefusal("withdraw_proposal")];
  const isOwn = useLogin((login) => login.me?.name !== undefined && login.me.name === nameOfAuthor(author));
  const isThere = useSession((s) => s.documents.some(({ name }) => name === document));
  const disabled = offline || busy;
  const isOutdated = status === "outdated";
  const since = isOutdated ? (base ?? undefined) : undefined;
  return (
    <div className="proposal-actions">
      <button type="button" className="is-main" disabled={disabled || isOutdated || mayAccept !== undefined} title={mayAccept ?? (isOutdated ? "The document has changed since" : "It becomes the next revision, which you can undo")} onClick={() => void attempt(async () => void (await accept(proposal)))}>
        Accept
      </button>
      <button type="button" disabled={disabled || mayDecline !== undefined} title={mayDecline} aria-expanded={asked} onClick={() => ask(!asked)}>
        Decline…
      </button>
      {isOwn && (
        <button type="button" disabled={disabled || mayWithdraw !== undefined} title={mayWithdraw} onClick={() => void attempt(async () => void (await withdraw(proposal)))}>
          Withdraw
        </button>
      )}
      {isThere && (
        <button type="button" disabled={offline} onClick={() => show(document, since)}>
          {since === undefined ? `Open ${document}` : `What has changed since revision ${since}`}
        </button>
      )}
      {asked && <DeclineForm disabled={disabled} onDecline={(why) => void attempt(async () => void (await decline(proposal, why)))} onCancel={() => ask(false)} />}
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </div>
  );
}

interface FormProps {
  readonly disabled: boolean;
  readonly onDecline: (reason: string) => void;
  readonly onCancel: () => void;
}

function DeclineForm({ disabled, onDecline, onCancel }: FormProps) {
  const [why, setWhy] = useState("");
  return (
    <form
      className="decline-form"
      onSubmit={(event) => {
        event.preventDefault();
        if (!disabled) onDecline(why);
      }}
    >
      <label>
        <span>Reason, for who has proposed it</span>
        <textarea
          autoFocus
          rows={2}
          maxLength={kMaxReason}
          value={why}
          onChange={(event) => setWhy(event.target.value)}
          onKeyDown={(event) => {
            if (event.key !== "Escape") return;
            event.preventDefault();
            event.stopPropagation();
            onCancel();
          }}
        />
      </label>
      <button type="submit" disabled={disabled}>
        Decline it
      </button>
      <button type="button" onClick={onCancel}>
        Cancel
      </button>
    </form>
  );
}
