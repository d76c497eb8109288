// Documents with errors. They are stored as drafts; no run can be made of them.
import type { DocumentSummary, ServerError } from "../../generated/messages";
import { errorsText } from "../run/errorsText";

/** A server that stores no drafts sends no errors. */
type Summary = Pick<DocumentSummary, "name"> & { readonly errors?: number };

export const errorCount = ({ errors }: Summary): number => errors ?? 0;

/** The document in a list. */
export function documentText(summary: Summary): string {
  const count = errorCount(summary);
  return count === 0 ? summary.name : `${summary.name} · draft, ${errorsText(count)}`;
}

/** Why no run can be made of the document; nothing if one can. */
export function refusalToStart(summary: Summary): string | undefined {
  const count = errorCount(summary);
  return count === 0 ? undefined : `${summary.name} is a draft with ${errorsText(count)}: it cannot be started`;
}

/** Where in the document an error is. */
export function placeText({ path, line, column }: ServerError): string {
  const at = line === undefined ? "" : `line ${line}${column === undefined ? "" : `, column ${column}`}`;
  return [path === "" ? "the whole document" : path, at].filter((part) => part !== "").join(", ");
}
