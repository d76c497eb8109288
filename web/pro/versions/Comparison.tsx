// What is compared: the changes, each with a way to its element; and what can be done with the revision.
import { useMemo, useState } from "react";
import { freeDocumentName } from "../../shared/documents/names";
import { namesOf } from "../../shared/documents/listed";
import { groupOf, groupRevisions } from "../../shared/versions/groups";
import { numbersText, rangeTitle } from "../../shared/versions/texts";
import { isSameRange, type Range } from "../../shared/versions/range";
import { useSession } from "../client";
import { NameForm } from "../documents/NameForm";
import { useAttempt } from "../documents/useAttempt";
import { useRefusal } from "../login/rights";
import { DifferenceList } from "../live/DifferenceList";
import { useComparedVersions } from "./compared";
import { branch, compareRange, restore, useHistory } from "./history";

export function Comparison({ range }: { readonly range: Range }) {
  const compared = useComparedVersions();
  const newest = useHistory((now) => now.revisions[0]?.revision);
  /** The revision that was chosen. */
  const chosen = range.to ?? range.from;
  return (
    <section className="comparison" aria-label="Comparison">
      <h3>{rangeTitle(range)}</h3>
      <Choice range={range} chosen={chosen} />
      <Changes compared={compared} />
      <Actions key={chosen} revision={chosen} isLast={chosen === newest} />
    </section>
  );
}

/** Since the revision, by it, or by all edits of its sitting. */
function Choice({ range, chosen }: { readonly range: Range; readonly chosen: number }) {
  const revisions = useHistory((now) => now.revisions);
  const sitting = useMemo(() => groupOf(groupRevisions(revisions), chosen), [revisions, chosen]);
  const choices: readonly { readonly text: string; readonly range: Range }[] = [
    { text: "since it", range: { from: chosen, to: undefined } },
    ...(chosen > 1 ? [{ text: "by it", range: { from: chosen - 1, to: chosen } }] : []),
    ...(sitting !== undefined && sitting.revisions.length > 1 && sitting.first.revision > 1
      ? [{ text: `by ${numbersText(sitting)}`, range: { from: sitting.first.revision - 1, to: sitting.last.revision } }]
      : []),
  ];
  return (
    <div className="comparison-range" role="radiogroup" aria-label={`Changes of revision ${chosen}`}>
      {choices.map((choice) => (
        <label key={choice.text}>
          <input type="radio" name="range" checked={isSameRange(range, choice.range)} onChange={() => compareRange(choice.range)} /> {choice.text}
        </label>
      ))}
    </div>
  );
}

function Changes({ compared }: { readonly compared: ReturnType<typeof useComparedVersions> }) {
  if (compared === undefined) return <p className="quiet pad">Loading…</p>;
  if ("reason" in compared) return <p className="bad pad">It cannot be compared: {compared.reason}</p>;
  const { rows, inDrawing } = compared;
  return (
    <>
      {rows.length > 0 && (
        <div className="comparison-rows">
          <DifferenceList compared={compared} label="Changes" />
        </div>
      )}
      {rows.length === 0 && !inDrawing && <p className="quiet pad">Nothing differs.</p>}
      {inDrawing && <p className="quiet pad">{rows.length === 0 ? "Only places" : "Places"} or notes differ{rows.length === 0 ? "." : ", too."}</p>}
    </>
  );
}

/** Restore and branch. */
function Actions({ revision, isLast }: { readonly revision: number; readonly isLast: boolean }) {
  const [asked, ask] = useState(false);
  const document = useHistory((now) => now.document);
  const documents = useSession((s) => s.documents);
  const offline = useSession((s) => s.connection !== "open");
  const taken = useMemo(() => namesOf(documents), [documents]);
  const { attempt, reason, busy } = useAttempt();
  const [mayRestore, mayBranch] = [useRefusal("restore_document"), useRefusal("branch_document")];
  return (
    <div className="comparison-actions">
      <button type="button" disabled={offline || busy || isLast || mayRestore !== undefined} title={mayRestore ?? (isLast ? "It is the last one" : "As a further revision: nothing is lost")} onClick={() => void attempt(() => restore(revision))}>
        Restore revision {revision}
      </button>
      <button type="button" disabled={offline || busy || mayBranch !== undefined} title={mayBranch} aria-expanded={asked} onClick={() => ask(!asked)}>
        Branch…
      </button>
      {asked && document !== undefined && (
        <NameForm label={`Name of the document that begins with revision ${revision}`} does="Branch" wish={freeDocumentName(document, taken)} taken={taken} disabled={offline || busy} focus onName={(as) => void attempt(() => branch(revision, as))} onCancel={() => ask(false)} />
      )}
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </div>
  );
}
