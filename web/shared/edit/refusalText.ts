// What the page says of an edit that was refused.
import { nameOfAuthor } from "../presence/names";
import type { Change, Notice } from "./session";

const kCompounds: Readonly<Record<string, string>> = {
  rename: "renaming", rename_service: "renaming the service", connect: "connecting", disconnect: "disconnecting", group: "grouping", ungroup: "ungrouping",
  duplicate: "duplicating", extract: "extracting to the library",
};

function deedOf(change: Change): string {
  if ("undo" in change) return "Undo";
  if ("redo" in change) return "Redo";
  if (!("compound" in change)) return "The edit";
  const deed = kCompounds[change.compound.kind] ?? "the edit";
  return `${deed.charAt(0).toUpperCase()}${deed.slice(1)}`;
}

/** The server quotes authors as they are; people know each other by their names. */
const withName = (message: string, author: string): string => message.replaceAll(`\`${author}\``, nameOfAuthor(author));

/** Why, and through whose edit. */
export function reasonText({ change, errors, author, revision }: Notice): string {
  const why = errors.map(({ path, message }) => (path === "" || "operations" in change || path.startsWith("compound/") ? message : `${path}: ${message}`)).join("; ");
  if (author !== undefined && why.includes(`\`${author}\``)) return withName(why, author);
  const by = author === undefined ? "" : ` (${nameOfAuthor(author)} was faster${revision === undefined ? "" : `, revision ${revision}`})`;
  return `${why}${by}`;
}

/** One sentence: what was refused, why, and through whose edit. */
export const refusalText = (notice: Notice): string => `${deedOf(notice.change)} was refused: ${reasonText(notice)}.`;
