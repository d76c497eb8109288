// The list of revisions: edits that one person made in one sitting are one row, which can be unfolded.
import type { DocumentRevision } from "../../generated/messages";

export interface RevisionGroup {
  readonly last: DocumentRevision;
  readonly first: DocumentRevision;
  /** The newest first. */
  readonly revisions: readonly DocumentRevision[];
}

/** After this time without an edit another sitting begins [ms]. */
export const kSitting = 10 * 60_000;

const isEdit = ({ origin: { kind } }: DocumentRevision): boolean => kind === "edit" || kind === "undo" || kind === "redo";

/** Whether `older` belongs to the row of the revision after it. What somebody has given a message stands by itself. */
const continues = (newer: DocumentRevision, older: DocumentRevision): boolean =>
  isEdit(newer) && isEdit(older) && newer.message === "" && older.message === "" && newer.author === older.author && newer.time - older.time <= kSitting;

/** The row that has a revision. */
export const groupOf = (groups: readonly RevisionGroup[], revision: number): RevisionGroup | undefined =>
  groups.find(({ first, last }) => first.revision <= revision && revision <= last.revision);

/** `revisions`: the newest first. */
export function groupRevisions(revisions: readonly DocumentRevision[]): readonly RevisionGroup[] {
  const groups: DocumentRevision[][] = [];
  for (const revision of revisions) {
    const group = groups.at(-1);
    const newer = group?.at(-1);
    if (group !== undefined && newer !== undefined && continues(newer, revision)) group.push(revision);
    else groups.push([revision]);
  }
  return groups.flatMap((all) => {
    const [last, first] = [all[0], all.at(-1)];
    return last === undefined || first === undefined ? [] : [{ last, first, revisions: all }];
  });
}
