// In the top bar: how many proposals wait for somebody who decides; nothing, if none does.
import { counted } from "../../shared/counted";
import { firstShown } from "../../shared/proposals/proposals";
import { showProposals, useProposals } from "./proposals";

export function ProposalsButton() {
  const undecided = useProposals((known) => known.undecided);
  if (undecided.length === 0) return null;
  return (
    <button type="button" className="proposals-button" title="Changes of documents that others propose: see what they would change, and decide" onClick={() => showProposals(firstShown(undecided))}>
      {counted(undecided.length, "proposal")}
    </button>
  );
}

/** The same of one document, beside its name. */
export function ProposalsOfDocument({ name, onShow }: { readonly name: string; readonly onShow: () => void }) {
  const undecided = useProposals((known) => known.undecided);
  const own = undecided.filter(({ document }) => document === name);
  if (own.length === 0) return null;
  return (
    <button
      type="button"
      className="proposals-button"
      onClick={() => {
        onShow();
        showProposals(firstShown(own));
      }}
    >
      {counted(own.length, "proposal")}
    </button>
  );
}
