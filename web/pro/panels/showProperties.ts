// To the panel where what is selected is shown and written.
import { unfold } from "../layout/panels";

/** The first thing in it that takes the focus has it. */
export function showProperties(): void {
  unfold("right");
  const panel = document.querySelector('.side-right, [aria-label="Properties"]');
  panel?.querySelector<HTMLElement>("input, textarea, select, [contenteditable=true], button, a")?.focus();
}
