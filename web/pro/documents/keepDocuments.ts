// Keeps the list of documents as the server has it, which no channel tells of: it is loaded anew when the open document has another revision, or is
// closed, and when a person comes back to the page.
import { loadDocuments, session } from "../client";
import { editing } from "../edit/editing";

/** Edits come faster than a list is read [ms]. */
const kRest = 400;

/** To be called once. */
export function keepDocuments(): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const load = () => {
    clearTimeout(timer);
    timer = setTimeout(() => session.get().connection === "open" && void loadDocuments(), kRest);
  };
  const last = () => editing.get().session?.confirmed?.revision;
  let known = last();
  editing.listen(() => {
    const revision = last();
    if (revision === known) return;
    const isOpened = known === undefined;
    known = revision;
    if (!isOpened) load();
  });
  addEventListener("focus", load);
}
