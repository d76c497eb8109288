// Over the page for a moment: an edit is in the run.
import { useEffect } from "react";
import type { Core } from "../../generated/messages";
import { carriedText } from "../../shared/run/edits";
import { watchedCore } from "../../shared/session/session";
import { session } from "../client";
import { createStore, useSelected } from "../../page/store";

/** How long it is shown [ms]. */
const kMoment = 8000;

interface Notice {
  readonly text: string;
}
const store = createStore<Notice | undefined, Notice | undefined>(undefined, (_, notice) => notice);

let before: Core | undefined;
session.listen(() => {
  const core = watchedCore(session.get());
  if (core === before) return;
  const text = before && core && carriedText(before, core);
  if (core?.id !== before?.id) store.dispatch(undefined);
  else if (text !== undefined) store.dispatch({ text });
  before = core;
});

export function Carried() {
  const notice = useSelected(store, (now) => now);
  useEffect(() => {
    if (notice === undefined) return;
    const timer = setTimeout(() => store.dispatch(undefined), kMoment);
    return () => clearTimeout(timer);
  }, [notice]);
  return (
    <p className="carried" role="status" aria-label="Edit in the run" hidden={notice === undefined}>
      {notice?.text}
    </p>
  );
}
