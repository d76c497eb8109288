// The history of a document in words.
import type { DocumentRevision } from "../../generated/messages";
import { assertNever } from "../assertNever";
import { nameOfAuthor } from "../presence/names";
import { errorsText } from "../run/errorsText";
import { timeText } from "../timeText";
import type { RevisionGroup } from "./groups";
import type { Range } from "./range";
import { counted } from "../counted";

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
    case "proposal":
      return "a proposal that was accepted";
    default:
      return assertNever(origin);
  }
}

const person = (author: string): string => (author === "" ? "somebody" : nameOfAuthor(author));

/** Who has made it; of a proposal, also who has proposed it. */
export const personText = ({ author, origin }: DocumentRevision): string => (origin.kind === "proposal" ? `${person(author)}, proposed by ${person(origin.author)}` : person(author));

/** What a row says of its revisions. */
export function groupText({ last, revisions }: RevisionGroup): string {
  if (last.message !== "") return last.message;
  if (revisions.length === 1) return originText(last);
  const undone = revisions.filter(({ origin }) => origin.kind === "undo").length;
  return `${counted(revisions.length, "edit")}${undone > 0 ? `, ${undone} of them undo` : ""}`;
}

export const numbersText = ({ first, last }: RevisionGroup): string => (first === last ? `${last.revision}` : `${first.revision} to ${last.revision}`);

export const draftText = ({ errors }: DocumentRevision): string | undefined => (errors === 0 ? undefined : `draft, ${errorsText(errors)}`);

/** When it was stored, if that is known. */
export const whenText = ({ time }: DocumentRevision, now: number): string => (time === 0 ? "at an unknown time" : timeText(time, now));

export const rangeTitle = ({ from, to }: Range): string => (to === undefined ? `Changed since revision ${from}` : to === from + 1 ? `Changed by revision ${to}` : `Changed by revisions ${from + 1} to ${to}`);
