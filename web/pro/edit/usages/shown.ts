// Whose usages are listed.
import { flushSync } from "react-dom";
import type { Referent } from "../../../shared/code/referent";
import { createStore, useSelected } from "../../../page/store";
import { editing } from "../editing";
import { kCanvasId } from "../prompt";

interface Shown {
  readonly document: string;
  readonly referent: Referent;
}

const store = createStore<Shown | undefined, Shown | undefined>(undefined, (_, next) => next);
let returnTo: Element | null = null;

export const kUsagesId = "usages";

/** Lists usages under the drawing; the list has the focus. */
export function showUsages(referent: Referent): void {
  const { document: name } = editing.get();
  if (name === undefined) return;
  if (store.get() === undefined) returnTo = document.activeElement;
  flushSync(() => store.dispatch({ document: name, referent }));
  const list = document.getElementById(kUsagesId);
  (list?.querySelector<HTMLElement>("li button") ?? list?.querySelector<HTMLElement>("button"))?.focus();
}

/** The focus returns to where it was. */
export function closeUsages(): void {
  flushSync(() => store.dispatch(undefined));
  const to = returnTo instanceof HTMLElement && returnTo.isConnected && returnTo !== document.body ? returnTo : document.getElementById(kCanvasId);
  to?.focus({ preventScroll: true });
}

/** Of the document that is edited. */
export const useShownUsages = (document: string | undefined): Referent | undefined => useSelected(store, (now) => (now?.document === document ? now?.referent : undefined));
