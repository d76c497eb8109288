// Closes what lies over the tasks on a small screen; the focus goes back to what opened it, or else to the card of what is selected.
import { place } from "./place";
import { focusCard } from "./select";
import { openerOfSheet, showSheet } from "./sheet";

/** Whether it has no focus that a person sees. */
const isUnseen = (element: Element | null): boolean => element === null || element === document.body || !element.checkVisibility();

export function closeSheet(): void {
  const opener = openerOfSheet();
  showSheet(undefined);
  requestAnimationFrame(() => {
    if (!isUnseen(document.activeElement)) return;
    const { step, task } = place();
    const shown = step ?? task;
    if (opener !== undefined && !isUnseen(opener)) opener.focus({ preventScroll: true });
    else if (shown !== undefined) focusCard(shown);
  });
}
