// Proposed changes of documents that nobody has decided about, as a page knows them, and which of them it shows.
import { assertNever } from "../assertNever";
import type { Proposal } from "../../generated/messages";

/** What is shown over the page: all of them, or one; nothing: the page itself. */
export type ShownProposals = { readonly id: string | undefined } | undefined;

export interface KnownProposals {
  /** The oldest first. */
  readonly undecided: readonly Proposal[];
  readonly shown: ShownProposals;
}

export type ProposalsEvent =
  /** `whole`: they are all; else those that are new or have another status. */
  | { readonly type: "told"; readonly proposals: readonly Proposal[]; readonly whole: boolean }
  | { readonly type: "show"; readonly shown: ShownProposals };

export const noProposals: KnownProposals = { undecided: [], shown: undefined };

export const isUndecided = ({ status }: Proposal): boolean => status === "open" || status === "outdated";

/** Ids are numbers, the larger the later. */
const byAge = (a: Proposal, b: Proposal): number => Number(a.id) - Number(b.id);

function withTold(before: readonly Proposal[], told: readonly Proposal[]): readonly Proposal[] {
  const ids = new Set(told.map(({ id }) => id));
  return [...before.filter(({ id }) => !ids.has(id)), ...told].filter(isUndecided).sort(byAge);
}

export function applyProposals(known: KnownProposals, event: ProposalsEvent): KnownProposals {
  switch (event.type) {
    case "told":
      return { ...known, undecided: withTold(event.whole ? [] : known.undecided, event.proposals) };
    case "show":
      return event.shown?.id === known.shown?.id && (event.shown === undefined) === (known.shown === undefined) ? known : { ...known, shown: event.shown };
    default:
      return assertNever(event);
  }
}

/** In an address, all of them. */
const kList = "list";

/** What is shown, as an address has it. */
export const shownText = (shown: ShownProposals): string | undefined => (shown === undefined ? undefined : (shown.id ?? kList));

/** What an address shows; nothing of what is neither. */
export function readShown(text: string | undefined): ShownProposals {
  if (text === kList) return { id: undefined };
  return text !== undefined && /^[0-9]{1,19}$/.test(text) ? { id: text } : undefined;
}

/** What a press on their number shows: the only one at once. */
export const firstShown = (proposals: readonly Proposal[]): ShownProposals => ({ id: proposals.length === 1 ? proposals[0]?.id : undefined });
