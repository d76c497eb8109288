// The document as the run executes it, and how what is edited differs from it.
import { useDeferredValue, useMemo } from "react";
import { differenceRows, differsInDrawing, type DifferenceRow } from "../../shared/edit/difference/rows";
import { difference } from "../../shared/edit/difference/difference";
import type { Tree } from "../../shared/edit/tree";
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

export interface Compared {
  readonly before: Tree;
  readonly after: Tree;
  readonly rows: readonly DifferenceRow[];
  /** Places or notes are not the same, either. */
  readonly inDrawing: boolean;
}

let last: Compared | undefined;

/** How two documents differ. What was compared last is not compared again. */
export function compare(before: Tree, after: Tree): Compared {
  if (last?.before === before && last.after === after) return last;
  const found = difference(before, after);
  last = { before, after, rows: differenceRows(before, after, found), inDrawing: differsInDrawing(found) };
  return last;
}

/** What is edited, compared with what runs; nothing: there is nothing to compare. While one types it may be a moment behind. */
export function useCompared(): Compared | undefined {
  const before = useExecuted();
  const after = useDeferredValue(useEditing((now) => now.session?.view));
  return useMemo(() => (before === undefined || "reason" in before || after === undefined ? undefined : compare(before, after)), [before, after]);
}
