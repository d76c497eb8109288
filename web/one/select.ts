// Selects a step or a task, for the panel and the address.
import { readApplication } from "../shared/timeline/read";
import { treeNow } from "./editing";
import { taskOf } from "./model";
import { go } from "./place";
import { showSheet } from "./sheet";

/** Shows a step, or a task by its own id. `opens`: on a small screen its settings, too. */
export function select(id: string, opens = true): void {
  const tree = treeNow();
  const task = tree === undefined ? undefined : taskOf(readApplication(tree), id);
  go({ task: task?.id, step: task?.id === id ? undefined : id });
  if (opens) showSheet("panel");
}

/** The card of a step gets the focus when it is drawn. */
export function focusCard(id: string): void {
  requestAnimationFrame(() => document.querySelector<HTMLElement>(`[data-step="${CSS.escape(id)}"] .card-open`)?.focus());
}
