// What is compared in the history, for its list and for the signs in the drawing.
import { useDeferredValue, useEffect, useMemo } from "react";
import { compare, type Compared } from "../../shared/edit/difference/compare";
import { useEditing } from "../edit/editing";
import { useHistory } from "./history";
import { loadRevision, useRevisionTree, type RevisionTree } from "./revisionTrees";

/** A revision of the document, which is loaded if it is not here. */
function useRevision(revision: number | undefined): RevisionTree | undefined {
  const document = useHistory((now) => now.document);
  const tree = useRevisionTree(document, revision);
  useEffect(() => {
    if (document !== undefined && revision !== undefined && tree === undefined) loadRevision(document, revision);
  }, [document, revision, tree]);
  return tree;
}

/** Nothing: nothing is compared, or not here yet. */
export function useComparedVersions(): Compared | { readonly reason: string } | undefined {
  const range = useHistory((now) => now.range);
  const before = useRevision(range?.from);
  const later = useRevision(range?.to);
  const now = useDeferredValue(useEditing((edited) => edited.session?.view));
  const after = range?.to === undefined ? now : later;
  return useMemo(() => {
    if (range === undefined || before === undefined || after === undefined) return undefined;
    if ("reason" in before) return { reason: `revision ${range.from}: ${before.reason}` };
    return "reason" in after ? { reason: `revision ${range.to ?? ""}: ${after.reason}` } : compare(before, after);
  }, [range, before, after]);
}
