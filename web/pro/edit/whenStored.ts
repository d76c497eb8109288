// Waiting until the server has all edits of this page.
import { editing } from "./editing";

/** How long that may take [ms]. */
const kPatience = 5000;

/** The revision that has them all, or why that does not come about soon. */
export type Stored = { readonly revision: number } | { readonly reason: string };

/** Nothing: it may still come about. */
function storedNow(): Stored | undefined {
  const { session } = editing.get();
  if (session?.confirmed === undefined) return { reason: "the document is not here" };
  if (!session.connected) return { reason: "the connection is lost: edits wait for it" };
  return session.pending.length > 0 || session.stale ? undefined : { revision: session.confirmed.revision };
}

export function whenStored(): Promise<Stored> {
  return new Promise((resolve) => {
    const take = (stored: Stored | undefined): void => {
      if (stored === undefined) return;
      clearTimeout(timer);
      stop();
      resolve(stored);
    };
    const timer = setTimeout(() => take({ reason: "the server has not stored all edits yet" }), kPatience);
    const stop = editing.listen(() => take(storedNow()));
    take(storedNow());
  });
}
