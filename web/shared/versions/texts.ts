// The history of a document in words.
import type { DocumentRevision } from "../../generated/messages";
import { assertNever } from "../assertNever";
import { nameOfAuthor } from "../presence/names";
import { errorsText } from "../run/errorsText";
import type { RevisionGroup } from "./groups";
import type { Range } from "./range";

/** Where the text of a revision comes from. */
export function originText({ origin }: DocumentRevision): string {
  switch (origin.kind) {
    case "put":
      return "stored as a whole";
    case "demo":
      return "the server's demo";
    case "older":
      return "kept by an older version of the program";
    case "edit":
      return "an edit";
    case "undo":
      return `undo of ${origin.revision}`;
    case "redo":
      return `redo, after the undo ${origin.revision}`;
    case "restore":
      return `revision ${origin.revision} restored`;
    case "branch":
      return `branched from ${origin.document}, revision ${origin.revision}`;
    default:
      return assertNever(origin);
  }
}

export const personText = ({ author }: DocumentRevision): string => (author === "" ? "somebody" : nameOfAuthor(author));

/** What a row says of its revisions. */
export function groupText({ last, revisions }: RevisionGroup): string {
  if (last.message !== "") return last.message;
  if (revisions.length === 1) return originText(last);
  const undone = revisions.filter(({ origin }) => origin.kind === "undo").length;
  return `${revisions.length} edits${undone > 0 ? `, ${undone} of them undo` : ""}`;
}

export const numbersText = ({ first, last }: RevisionGroup): string => (first === last ? `${last.revision}` : `${first.revision} to ${last.revision}`);

export const draftText = ({ errors }: DocumentRevision): string | undefined => (errors === 0 ? undefined : `draft, ${errorsText(errors)}`);

const two = (n: number): string => String(n).padStart(2, "0");

/** `09:05` of today, else `2026-11-26 09:05`, in the time zone of the page. Times in ms since 1970; 0: not known. */
export function timeText(time: number, now: number): string {
  if (time === 0) return "at an unknown time";
  const [at, today] = [new Date(time), new Date(now)];
  const clock = `${two(at.getHours())}:${two(at.getMinutes())}`;
  if (at.toDateString() === today.toDateString()) return clock;
  return `${at.getFullYear()}-${two(at.getMonth() + 1)}-${two(at.getDate())} ${clock}`;
}

export const rangeTitle = ({ from, to }: Range): string => (to === undefined ? `Changed since revision ${from}` : to === from + 1 ? `Changed by revision ${to}` : `Changed by revisions ${from + 1} to ${to}`);
