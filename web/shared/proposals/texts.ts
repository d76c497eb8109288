// Proposals in words.
import type { Proposal } from "../../generated/messages";
import { assertNever } from "../assertNever";
import { nameOfAuthor } from "../presence/names";

const somebody = (author: string): string => (author === "" ? "somebody" : nameOfAuthor(author));

export const proposerText = ({ author }: Proposal): string => somebody(author);

/** What it is about: `task, revision 3`, `wave, a new document`. */
export const subjectText = ({ document, base_revision: base }: Proposal): string => (base === null ? `${document}, a new document` : `${document}, revision ${base}`);

/** Of its drawing. */
export const drawingTitle = ({ document, base_revision: base }: Proposal): string => (base === null ? `The states of ${document}` : `What it would change, in the drawing of ${document}`);

/** What has become of it. */
export function statusText(proposal: Proposal): string {
  const by = somebody(proposal.decided_by ?? "");
  switch (proposal.status) {
    case "open":
      return "open";
    case "outdated":
      return "outdated";
    case "accepted":
      return `accepted by ${by}${proposal.revision === undefined ? "" : `, as revision ${proposal.revision}`}`;
    case "declined":
      return `declined by ${by}${proposal.reason === undefined ? "" : `: ${proposal.reason}`}`;
    case "withdrawn":
      return `withdrawn by ${by}`;
    default:
      return assertNever(proposal.status);
  }
}

/** Why it cannot be accepted, and what to do. */
export const outdatedText = ({ document, author, base_revision: base }: Proposal): string => {
  const what = base === null ? `There is a document ${document} by now` : `${document} has changed since revision ${base}`;
  return `${what}: this proposal cannot be accepted any more. Decline it, so that ${somebody(author)} proposes it anew for the document as it is, or make the change by hand.`;
};

export const kNoNote = "Nothing is said about why.";
