// A modal dialog of a component: shown from its first drawing on, with the focus where a person begins. It gives the focus back when it is closed (keepFocus.ts).
import { useEffect, useRef, type RefObject } from "react";

/** What a person fills in, or else reads first; STOP lies in the dialog, too. */
const kFirst = ["[data-first]", ":is(input, select, textarea):enabled", ":is(h1, h2, h3)"] as const;

function focusFirst(dialog: HTMLDialogElement): void {
  const inside = (selector: string) => [...dialog.querySelectorAll<HTMLElement>(selector)].find((each) => each.closest("#stop-layer") === null);
  const first = kFirst.map(inside).find((each) => each !== undefined);
  if (first === undefined) return;
  // A heading is no stop of Tab.
  if (first.matches("h1, h2, h3")) first.tabIndex = -1;
  first.focus();
}

/** Of its `<dialog ref>`. Close it by its own `close()`, so that what opened it gets the focus back. */
export function useModal(): RefObject<HTMLDialogElement | null> {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const shown = dialog.current;
    if (shown === null || shown.open) return;
    shown.showModal();
    focusFirst(shown);
  }, []);
  return dialog;
}
