// Forcing an outcome or a value: proposed by a menu or a table, done when it is confirmed (ForceBar.tsx).
import { typedValue, type Proposal } from "../../shared/debugger/force";
import { watchedCore } from "../../shared/session/session";
import { api, session } from "../client";
import { createStore, useSelected } from "../../page/store";
import { messageOf } from "../../shared/messageOf";

const store = createStore<Proposal | undefined, Proposal | undefined>(undefined, (_, proposal) => proposal);
let returnTo: Element | null = null;

export const useProposal = (): Proposal | undefined => useSelected(store, (proposal) => proposal);

export function propose(proposal: Proposal): void {
  returnTo = document.activeElement;
  store.dispatch(proposal);
}

/** It is done, or given up: the focus returns. */
export function endProposal(): void {
  store.dispatch(undefined);
  if (returnTo instanceof HTMLElement && returnTo.isConnected) returnTo.focus({ preventScroll: true });
  returnTo = null;
}

/** Does it in the watched run. The result says why it could not be done. */
export async function force({ path, scope, name }: Proposal, text: string): Promise<string | undefined> {
  const core = watchedCore(session.get());
  if (core === undefined) return "No run is watched.";
  const typed = scope === "port" ? undefined : typedValue(text);
  if (typed !== undefined && "reason" in typed) return typed.reason;
  try {
    await api.force(core.id, { path, scope, name, ...(typed !== undefined && { value: typed.value }) });
    endProposal();
    return undefined;
  } catch (error) {
    return messageOf(error);
  }
}
