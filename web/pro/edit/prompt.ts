// What the editor asks over the page: a name in place, a choice from a menu, a command. One at a time; the focus returns to where it was.
import { flushSync } from "react-dom";
import { createStore, useSelected } from "../../page/store";

export interface MenuEntry {
  readonly name: string;
  readonly keys?: string;
  /** Why it cannot be chosen now. */
  readonly reason?: string | undefined;
  readonly run: () => void;
}

/** A place on the screen [px]. */
export interface ScreenPoint {
  readonly x: number;
  readonly y: number;
}

export type Prompt =
  | { readonly kind: "palette" }
  | { readonly kind: "menu"; readonly label: string; readonly at: ScreenPoint; readonly entries: readonly MenuEntry[] }
  /** `commit` gives the reason why the name is none, and then the question stays. */
  | { readonly kind: "name"; readonly label: string; readonly at: ScreenPoint & { readonly width: number }; readonly value: string; readonly commit: (name: string) => string | undefined };

const store = createStore<Prompt | undefined, Prompt | undefined>(undefined, (_, prompt) => prompt);
let returnTo: Element | null = null;

export const usePrompt = (): Prompt | undefined => useSelected(store, (prompt) => prompt);

/** Whether the page waits for an answer. */
export const isPrompting = (): boolean => store.get() !== undefined;

export function ask(prompt: Prompt): void {
  // What is in the drawing may be drawn anew meanwhile.
  if (store.get() === undefined) returnTo = document.activeElement?.closest(`#${kCanvasId}`) ?? document.activeElement;
  store.dispatch(prompt);
}

/** Ends the question; what had the focus before has it again, unless it is gone: then the drawing. */
export function endPrompt(): void {
  if (store.get() === undefined) return;
  const to = returnTo instanceof HTMLElement && returnTo.isConnected && returnTo !== document.body ? returnTo : document.getElementById(kCanvasId);
  // What lies over the page is gone before the page has the focus again.
  flushSync(leavePrompt);
  to?.focus({ preventScroll: true });
}

/** Ends the question; the focus stays where the user has put it. */
export function leavePrompt(): void {
  returnTo = null;
  store.dispatch(undefined);
}

/** Of the element that has the focus while one works on the drawing. */
export const kCanvasId = "edit-canvas";
