// The coverage of tests that somebody has opened: a file, of which one model is shown, or why it cannot be.
import { useMemo } from "react";
import { createStore, useSelected } from "../../page/store";
import { coverageOf, type DocumentCoverage } from "../../shared/coverage/coverage";
import { drawnCoverage, type DrawnCoverage } from "../../shared/coverage/drawnCoverage";
import { documentOfModel, kMostReportBytes, modelFor, readReport, type CoverageReport } from "../../shared/coverage/report";
import { sizeText } from "../../shared/documents/uploads";
import { messageOf } from "../../shared/messageOf";
import { useShownCanvas } from "../canvas/canvasView";
import { session } from "../client";
import { editing, openDocument, useEditing } from "../edit/editing";
import { isHistoryShown, showHistory, useHistory } from "../versions/history";

interface Opened {
  /** The panel, and with it the signs in the drawing, unless the history is over it. */
  readonly shown: boolean;
  readonly report?: CoverageReport;
  /** A model of it that was chosen; nothing: that of the document. */
  readonly model?: string;
  /** Why the last file is not shown. */
  readonly reason?: string;
}

const store = createStore<Opened, Opened>({ shown: false }, (_, next) => next);

export const useOpened = <T>(select: (opened: Opened) => T): T => useSelected(store, select);

export const isCoverageShown = (): boolean => store.get().shown && !isHistoryShown();

export function useCoverageShown(): boolean {
  const history = useHistory((now) => now.shown);
  return useOpened((opened) => opened.shown) && !history;
}

/** Shows the panel, which stands where the history does; closed, the file is forgotten. */
export function showCoverage(shown: boolean): void {
  if (shown) showHistory(false);
  store.dispatch(shown ? { ...store.get(), shown } : { shown });
}

export const chooseModel = (model: string): void => store.dispatch({ ...store.get(), model });

async function read(file: File): Promise<CoverageReport> {
  if (file.size > kMostReportBytes) throw new Error(`${file.name} has ${sizeText(file.size)}; at most ${sizeText(kMostReportBytes)} are read.`);
  return readReport(file.name, await file.text());
}

/** Opens a file on the document that is open; else on that of its name. Throws why it cannot. */
export async function openDroppedCoverage(file: File): Promise<void> {
  const report = await read(file);
  const named = Object.keys(report.models).map(documentOfModel);
  const document = editing.get().document ?? session.get().documents.find(({ name }) => named.includes(name))?.name;
  if (document === undefined) throw new Error(`The server has no document ${named[0] ?? ""}: open the document of ${file.name} first.`);
  openDocument(document);
  showCoverage(true);
  store.dispatch({ shown: true, report });
}

/** The same on the panel: what is no coverage is told there, and the file before stays. */
export async function openCoverage(file: File): Promise<void> {
  try {
    store.dispatch({ shown: true, report: await read(file) });
  } catch (error) {
    store.dispatch({ ...store.get(), shown: true, reason: messageOf(error) });
  }
}

export interface ShownCoverage extends DocumentCoverage {
  readonly report: CoverageReport;
  readonly model: string;
}

/** What the file says of the document that is edited; nothing: no file is open, or the document is not here. */
export function useCoverage(): ShownCoverage | undefined {
  const shown = useCoverageShown();
  const opened = useOpened((now) => now.report);
  const report = shown ? opened : undefined;
  const chosen = useOpened(({ model }) => model);
  const document = useEditing((now) => now.document);
  const tree = useEditing((now) => now.session?.view);
  return useMemo(() => {
    if (report === undefined || tree === undefined) return undefined;
    const model = chosen ?? modelFor(report, document);
    const found = report.models[model];
    return found === undefined ? undefined : { ...coverageOf(tree, found), report, model };
  }, [report, chosen, document, tree]);
}

/** More signs would slow the drawing down. */
export const kMostDrawn = 400;

/** What of it is in the drawing that is shown. */
export function useDrawnCoverage(): readonly DrawnCoverage[] {
  const laid = useShownCanvas()?.laid;
  const marks = useCoverage()?.marks;
  return useMemo(() => (laid === undefined || marks === undefined ? [] : drawnCoverage(marks, laid)), [laid, marks]);
}
