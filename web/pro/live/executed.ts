// The document as the run executes it, and how what is edited differs from it.
import { useDeferredValue, useMemo } from "react";
import { compare, type Compared } from "../../shared/edit/difference/compare";
import { runOfDocument } from "../../shared/live/shownRun";
import { watchedCore } from "../../shared/session/session";
import { session } from "../client";
import { editing, useEditing } from "../edit/editing";
import { loadRevision, useRevisionTree, type RevisionTree } from "../versions/revisionTrees";
import { useRunOfDocument } from "./shownRun";

function loadExecuted(): void {
  const { document, session: edited } = editing.get();
  const core = runOfDocument(watchedCore(session.get()), document);
  if (core === undefined || document === undefined || edited?.confirmed === undefined) return;
  loadRevision(document, core.revision);
}
editing.listen(loadExecuted);
session.listen(loadExecuted);

/** The document as the run of it executes it; nothing: it is not here, or there is no run. */
export function useExecuted(): RevisionTree | undefined {
  const core = useRunOfDocument();
  return useRevisionTree(core?.document, core?.revision);
}

/** What is edited, compared with what runs; nothing: there is nothing to compare. While one types it may be a moment behind. */
export function useCompared(): Compared | undefined {
  const before = useExecuted();
  const after = useDeferredValue(useEditing((now) => now.session?.view));
  return useMemo(() => (before === undefined || "reason" in before || after === undefined ? undefined : compare(before, after)), [before, after]);
}
