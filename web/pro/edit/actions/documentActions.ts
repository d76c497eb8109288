// Actions on the document as a whole.
import { refusalToStart } from "../../../shared/session/draft";
import { requestRun } from "../../documents/asking";
import { view } from "../../client";
import { closeDocument, editing, mayClose } from "../editing";
import { ask } from "../prompt";
import { refuse, tellDone } from "../say";
import { whenStored } from "../whenStored";
import { isCoverageShown, showCoverage } from "../../coverage/coverage";
import { isHistoryShown, showHistory } from "../../versions/history";
import type { Action } from "./action";

const always = (): undefined => undefined;

/** A field that has the focus is left for a moment, so that what is written in it counts. */
function leaveField(): void {
  const field = document.activeElement;
  if (!(field instanceof HTMLElement)) return;
  field.blur();
  field.focus({ preventScroll: true });
}

async function tellSaved(): Promise<void> {
  const stored = await whenStored();
  if ("reason" in stored) refuse(stored.reason);
  else tellDone(`All is saved, as revision ${stored.revision}: every edit is stored at once.`);
}

const saving: Action = {
  id: "save", name: "Save", keys: ["Ctrl+S"], group: "Document", where: "anywhere",
  when: always,
  run: () => {
    leaveField();
    void tellSaved();
  },
};

/** Why no run can be made of the document. */
function reasonAgainstRun(): string | undefined {
  const { document, session: edited } = editing.get();
  return document === undefined ? "no document is open" : refusalToStart({ name: document, errors: edited?.errors.length ?? 0 });
}

let isMaking = false;

/** Makes a run of what is shown, and shows it. It is not started. */
async function makeRun(document: string): Promise<void> {
  if (isMaking) return;
  isMaking = true;
  const stored = await whenStored();
  const reason = "reason" in stored ? stored.reason : reasonAgainstRun();
  if (reason === undefined) await requestRun(document, false);
  else refuse(reason);
  isMaking = false;
}

const running: Action = {
  id: "run", name: "Make a run of this document", keys: ["F5"], group: "Document", where: "anywhere",
  when: reasonAgainstRun,
  run: ({ document }) => {
    leaveField();
    void makeRun(document);
  },
};

const palette: Action = {
  id: "palette", name: "All commands", keys: ["Ctrl+Shift+P"], group: "Document", where: "anywhere", when: always,
  run: () => ask({ kind: "palette" }),
};

const versions: Action = {
  id: "history", name: "History of the document, or close it", keys: ["Ctrl+Shift+H"], group: "Document", where: "anywhere", when: always,
  run: () => showHistory(!isHistoryShown()),
};

const coverage: Action = {
  id: "coverage", name: "Coverage of tests on the document, or close it", keys: ["Ctrl+Shift+Y"], group: "Document", where: "anywhere", when: always,
  run: () => showCoverage(!isCoverageShown()),
};

const closing: Action = {
  id: "close", name: "Close the document", keys: [], group: "Document", where: "untyped", when: always,
  run: () => {
    if (!mayClose()) return;
    view.dispatch({ type: "page", page: "task" });
    closeDocument();
  },
};

export const documentActions: readonly Action[] = [saving, running, palette, versions, coverage, closing];
