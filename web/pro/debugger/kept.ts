// The breakpoints of the person here at the document that the page shows, as components see them.
import type { Entry } from "../../shared/debugger/breakpoints";
import { createStore, useSelected } from "../../page/store";

/** Whose breakpoints they are, and at which document. */
export interface Owner {
  readonly document: string;
  readonly author: string;
}

export interface Kept {
  /** Nothing: no document is shown. */
  readonly of: Owner | undefined;
  readonly entries: readonly Entry[];
  /** They are here, so they can be changed. */
  readonly loaded: boolean;
  /** Why the server has not kept the last change. */
  readonly unkept: string | undefined;
  /** Why a core did not take a breakpoint, by its key. */
  readonly refused: ReadonlyMap<string, string>;
}

export const kNothingKept: Kept = { of: undefined, entries: [], loaded: false, unkept: undefined, refused: new Map() };

const store = createStore<Kept, Partial<Kept>>(kNothingKept, (before, change) => ({ ...before, ...change }));

export const kept = (): Kept => store.get();
export const setKept = (change: Partial<Kept>): void => store.dispatch(change);
export const useKept = <T>(select: (kept: Kept) => T): T => useSelected(store, select);
