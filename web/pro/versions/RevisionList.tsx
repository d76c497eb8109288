// The revisions, the newest first. Edits of one sitting are one row, which unfolds.
import { useMemo, useState } from "react";
import { groupRevisions, type RevisionGroup } from "../../shared/versions/groups";
import type { Range } from "../../shared/versions/range";
import { draftText, groupText, numbersText, personText, whenText } from "../../shared/versions/texts";
import { compareRange, loadNewest, loadOlder, useHistory } from "./history";

export function RevisionList() {
  const { revisions, next, reason, range } = useHistory((now) => now);
  const groups = useMemo(() => groupRevisions(revisions), [revisions]);
  const [unfolded, setUnfolded] = useState<ReadonlySet<number>>(new Set());
  const [now] = useState(() => Date.now());
  const fold = (group: number) => setUnfolded((before) => new Set(before.has(group) ? [...before].filter((each) => each !== group) : [...before, group]));
  if (reason !== undefined)
    return (
      <p className="bad pad" role="alert">
        The history cannot be loaded: {reason}{" "}
        <button type="button" className="link" onClick={() => void loadNewest()}>
          Try again
        </button>
      </p>
    );
  if (revisions.length === 0) return <p className="quiet pad">Loading…</p>;
  return (
    <>
      <ol className="revisions" aria-label="Revisions">
        {groups.map((group) => {
          // A row keeps its number while edits are added to it.
          const key = group.first.revision;
          const isUnfolded = unfolded.has(key);
          return (
            <li key={key}>
              <Row group={group} range={range} now={now} />
              {group.revisions.length > 1 && (
                <button type="button" className="revision-fold" aria-expanded={isUnfolded} aria-label={`Revisions ${numbersText(group)} one by one`} onClick={() => fold(key)}>
                  {isUnfolded ? "▾" : "▸"}
                </button>
              )}
              {isUnfolded && (
                <ol aria-label={`Revisions ${numbersText(group)}`}>
                  {group.revisions.map((each) => (
                    <li key={each.revision}>
                      <Row group={{ last: each, first: each, revisions: [each] }} range={range} now={now} />
                    </li>
                  ))}
                </ol>
              )}
            </li>
          );
        })}
      </ol>
      {next !== undefined && (
        <button type="button" className="revisions-older" onClick={() => void loadOlder()}>
          Older revisions
        </button>
      )}
    </>
  );
}

interface RowProps {
  readonly group: RevisionGroup;
  readonly range: Range | undefined;
  /** In ms since 1970. */
  readonly now: number;
}

function Row({ group, range, now }: RowProps) {
  const { last } = group;
  const isChosen = (range?.to ?? range?.from) === last.revision;
  const draft = draftText(last);
  return (
    <button type="button" className="revision-row" aria-pressed={isChosen} onClick={() => compareRange(isChosen ? undefined : { from: last.revision, to: undefined })}>
      <b>{numbersText(group)}</b>
      <span>{groupText(group)}</span>
      <small>
        {personText(last)}, <time dateTime={new Date(last.time).toISOString()}>{whenText(last, now)}</time>
        {draft !== undefined && <em> · {draft}</em>}
      </small>
    </button>
  );
}
