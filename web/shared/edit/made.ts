// What an edit of this page has made, once the server has made it.
import type { Change, EditSession } from "./session";

const waits = (session: EditSession | undefined, change: Change): boolean => session?.pending.some((edit) => edit.change === change) === true;

/** Whether the server has not answered this change. */
export const isWaiting = waits;

/** The new elements that are in no other new one, if `change` came between the two sessions; nothing: it has not. */
export function madeBetween(before: EditSession | undefined, after: EditSession | undefined, change: Change): readonly string[] | undefined {
  if (!waits(before, change) || waits(after, change)) return undefined;
  const [old, now] = [before?.view, after?.view];
  if (old === undefined || now === undefined) return [];
  return [...now.elements.values()].filter(({ id, parent }) => !old.elements.has(id) && (parent === "" || old.elements.has(parent))).map(({ id }) => id);
}
