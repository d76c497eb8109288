// To the comments on an element of the document that is edited: it is selected, so that its form with them is there.
import { flushSync } from "react-dom";
import { unfold } from "../layout/panels";
import { selectById } from "../edit/forms/selectById";

const sectionOf = (element: string): HTMLElement | null => document.querySelector<HTMLElement>(`[data-comments="${CSS.escape(element)}"]`);

/** Into the field for a new comment. Whether there is one. */
export function focusComments(element: string): boolean {
  const field = sectionOf(element)?.querySelector<HTMLElement>(":scope > .comment-field:last-of-type textarea");
  field?.focus();
  field?.scrollIntoView({ block: "nearest" });
  return field !== null && field !== undefined;
}

/** To a thread, that which begins with `first`; else to the first one that is open. */
export function goToComments(element: string, first?: string): void {
  unfold("right");
  flushSync(() => selectById(element));
  const thread = sectionOf(element)?.querySelector<HTMLElement>(first === undefined ? ".thread" : `[data-thread="${CSS.escape(first)}"]`);
  thread?.focus({ preventScroll: true });
  thread?.scrollIntoView({ block: "nearest" });
}
