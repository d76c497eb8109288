// The documents of the server, as the page lists them.
import type { DocumentSummary } from "../../generated/messages";

/** Documents with all words of the query in their name or description, in any case. */
export function matching(documents: readonly DocumentSummary[], query: string): readonly DocumentSummary[] {
  const words = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
  return documents.filter(({ name, doc = "" }) => {
    const text = `${name} ${doc}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

export const namesOf = (documents: readonly DocumentSummary[]): ReadonlySet<string> => new Set(documents.map(({ name }) => name));
