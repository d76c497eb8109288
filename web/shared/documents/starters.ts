// The documents that an empty page offers to start with.
import type { DocumentSummary } from "../../generated/messages";
import { errorCount } from "../session/draft";

/** So many are shown; all of them are in the list of documents. */
export const kMostStarters = 6;

/** First those that can be started and say what they do, then the others that can, then drafts; by name. */
export function starters(documents: readonly DocumentSummary[], most = kMostStarters): readonly DocumentSummary[] {
  const rank = (each: DocumentSummary): number => (errorCount(each) > 0 ? 2 : each.doc === undefined ? 1 : 0);
  return [...documents].sort((a, b) => rank(a) - rank(b) || a.name.localeCompare(b.name)).slice(0, most);
}
