// Over the run bar: what is to be forced in the run, with what it means, until it is confirmed or given up.
import { useEffect, useRef, useState, type KeyboardEvent, type SyntheticEvent } from "react";
import { proposalText, type Proposal } from "../../shared/debugger/force";
import { endProposal, force, useProposal } from "./forcing";

export function ForceBar() {
  const proposal = useProposal();
  return proposal === undefined ? null : <Bar key={`${proposal.scope} ${proposal.path} ${proposal.name}`} proposal={proposal} />;
}

function Bar({ proposal }: { readonly proposal: Proposal }) {
  const [text, setText] = useState(proposal.text ?? "");
  const [reason, setReason] = useState<string>();
  const field = useRef<HTMLInputElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => (field.current ?? button.current)?.focus(), []);
  const confirm = async (event: SyntheticEvent) => {
    event.preventDefault();
    setReason(await force(proposal, text));
  };
  const press = (event: KeyboardEvent) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    event.preventDefault();
    endProposal();
  };
  return (
    <form className="force-bar" aria-label="Force" onSubmit={(event) => void confirm(event)} onKeyDown={press}>
      <strong>{proposalText(proposal)}</strong>
      {proposal.scope !== "port" && <input ref={field} aria-label={`Value of ${proposal.name}`} spellCheck={false} value={text} onChange={({ target }) => setText(target.value)} />}
      <button ref={button} type="submit" className="force-confirm">
        Force it
      </button>
      <button type="button" onClick={endProposal}>
        Cancel
      </button>
      <span>It is recorded in the journal of the run as forced. The task goes on from there, so the robot may move.</span>
      {reason !== undefined && <p role="alert">{reason}</p>}
    </form>
  );
}
