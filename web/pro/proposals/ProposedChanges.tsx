// What a proposal would change, drawn and in words: how its document differs from the revision that it was made of; of a new document, what it has.
import { useEffect, useMemo } from "react";
import type { Proposal } from "../../generated/messages";
import { Refusal } from "../../shared/edit/refusal";
import { readTree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import { outlineOf, type Outline } from "../../shared/proposals/outline";
import { drawingTitle } from "../../shared/proposals/texts";
import { DifferenceText } from "../live/DifferenceList";
import { loadRevision, useRevisionTree } from "../versions/revisionTrees";
import { ProposalDrawing } from "./ProposalDrawing";

/** So many are listed. */
const kMost = 200;

/** Nothing: the revision, or the proposed document, is not here yet. */
function useOutline({ document, base_revision: base, proposed }: Proposal): Outline | { readonly reason: string } | undefined {
  const before = useRevisionTree(document, base ?? undefined);
  useEffect(() => {
    if (base !== null && before === undefined) loadRevision(document, base);
  }, [document, base, before]);
  return useMemo(() => {
    if (proposed === undefined) return undefined;
    const after = readTree(proposed as JsonValue);
    if (after instanceof Refusal) return { reason: after.message };
    if (base === null) return outlineOf(undefined, after);
    if (before === undefined) return undefined;
    return "reason" in before ? { reason: before.reason } : outlineOf(before, after);
  }, [proposed, base, before]);
}

export function ProposedChanges({ proposal }: { readonly proposal: Proposal }) {
  const outline = useOutline(proposal);
  if (outline === undefined) return <p className="quiet">Loading…</p>;
  if ("reason" in outline) return <p className="bad">What it would change cannot be shown: {outline.reason}</p>;
  const { rows, inDrawing } = outline;
  return (
    <>
      <ProposalDrawing outline={outline} title={drawingTitle(proposal)} />
      {rows.length > 0 && (
        <ul className="proposal-changes" aria-label="What it would change">
          {rows.slice(0, kMost).map((row) => (
            <li key={`${row.kind} ${row.id}`} className={`difference is-${row.kind}`}>
              <DifferenceText row={row} />
            </li>
          ))}
          {rows.length > kMost && <li className="quiet">{rows.length - kMost} more</li>}
        </ul>
      )}
      {rows.length === 0 && !inDrawing && <p className="quiet">It would change nothing.</p>}
      {inDrawing && <p className="quiet">{rows.length === 0 ? "Only places" : "Places"} or notes would change{rows.length === 0 ? "." : ", too."}</p>}
    </>
  );
}
