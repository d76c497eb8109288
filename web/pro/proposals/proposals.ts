// Proposed changes of documents: those that nobody has decided about, which of them are shown (also in the address), and what is decided.
import type { Proposal } from "../../generated/messages";
import { applyProposals, noProposals, readShown, shownText, type KnownProposals, type ProposalsEvent, type ShownProposals } from "../../shared/proposals/proposals";
import { addressWith, placeOfAddress } from "../../shared/session/address";
import { api, listenToStream, loadDocuments } from "../client";
import { author } from "../edit/author";
import { createStore, useSelected } from "../../page/store";

const store = createStore<KnownProposals, ProposalsEvent>(noProposals, applyProposals);

export const useProposals = <T>(select: (known: KnownProposals) => T): T => useSelected(store, select);

/** Whether they cover the page. */
export const areProposalsShown = (): boolean => store.get().shown !== undefined;

/** Shows all, one, or the page again. */
export function showProposals(shown: ShownProposals): void {
  store.dispatch({ type: "show", shown });
  const proposals = shownText(shown);
  if (placeOfAddress(location.search).proposals !== proposals) history.replaceState(null, "", addressWith(location.search, { proposals }));
}

/** Follows the channel and the address; to be called once, when the page is connected. */
export function followProposals(): void {
  const { stream } = listenToStream({
    update: (update) => {
      if (update.type === "proposals") store.dispatch({ type: "told", proposals: update.proposals, whole: update.whole });
    },
    connection: () => undefined,
  });
  stream.subscribe("proposals");
  const read = () => store.dispatch({ type: "show", shown: readShown(placeOfAddress(location.search).proposals) });
  read();
  addEventListener("popstate", read);
}

/** Makes it the next revision of its document. Throws what the server refuses. */
export async function accept({ id }: Proposal): Promise<Proposal> {
  const accepted = await api.acceptProposal(id, author());
  await loadDocuments();
  return accepted;
}

/** `reason`: may be empty. Throws what the server refuses. */
export const decline = ({ id }: Proposal, reason: string): Promise<Proposal> => api.declineProposal(id, author(), reason.trim());

/** Throws what the server refuses. */
export const withdraw = ({ id }: Proposal): Promise<Proposal> => api.withdrawProposal(id, author());
