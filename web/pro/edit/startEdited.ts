// The key that starts runs, on the page that edits a document.
import { refusalToStart } from "../../shared/session/draft";
import { problem } from "../client";
import { makeRun } from "../documents/actions";
import { editing } from "./editing";

/** Makes a run of the document, which its key starts; of a draft it says why there is none. */
export function startEdited(): boolean {
  const { document, session } = editing.get();
  if (document === undefined) return false;
  const refusal = refusalToStart({ name: document, errors: session?.errors.length ?? 0 });
  if (refusal !== undefined) problem(refusal);
  else void makeRun(document);
  return true;
}
