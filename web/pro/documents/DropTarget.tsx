// Files that are dragged over the page, and dropped anywhere on it, are uploaded.
import { useEffect, useState } from "react";
import { isTestReport } from "../../shared/coverage/report";
import { isRunFile, kMostRunBytes } from "../../shared/runs/runFile";
import { attempt, problem } from "../client";
import { openDroppedCoverage } from "../coverage/coverage";
import { refusalNow, useRefusal } from "../login/rights";
import { openRunFile } from "../runs/actions";
import { showDocuments } from "./actions";
import { upload } from "./uploading";

/** Runs are stored and shown, coverage of tests is shown; all else becomes documents. */
async function takeFiles(files: readonly File[]): Promise<void> {
  const texts = await Promise.all(files.map(async (file) => (file.size <= kMostRunBytes ? file.text() : "")));
  const runs = texts.filter(isRunFile);
  const reports = files.filter((_, i) => isTestReport(texts[i] ?? ""));
  const documents = files.filter((file, i) => !runs.includes(texts[i] ?? "") && !reports.includes(file));
  const refusal = (runs.length > 0 ? refusalNow("import_run") : undefined) ?? (documents.length > 0 ? refusalNow("store_document") : undefined);
  if (refusal !== undefined) {
    problem(`Nothing is stored: ${refusal}.`);
    return;
  }
  if (documents.length > 0) {
    upload(documents);
    showDocuments(true);
  }
  for (const report of reports) await attempt(() => openDroppedCoverage(report));
  for (const run of runs) await attempt(() => openRunFile(run));
}

const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") === true;

/** Says where files go while some are dragged. Whatever is below gets no event of them. */
export function DropTarget() {
  const [over, setOver] = useState(false);
  const refusal = useRefusal("store_document");
  useEffect(() => {
    const take = (event: DragEvent) => {
      if (!hasFiles(event)) return false;
      event.preventDefault();
      event.stopPropagation();
      return true;
    };
    const drag = (event: DragEvent) => take(event) && setOver(true);
    /** The pointer has left the window: it has not come to another element. */
    const leave = (event: DragEvent) => take(event) && event.relatedTarget === null && setOver(false);
    const drop = (event: DragEvent) => {
      if (!take(event)) return;
      setOver(false);
      void takeFiles([...(event.dataTransfer?.files ?? [])]);
    };
    const listeners = { dragenter: drag, dragover: drag, dragleave: leave, drop };
    for (const [type, listener] of Object.entries(listeners)) addEventListener(type, listener as EventListener, true);
    return () => {
      for (const [type, listener] of Object.entries(listeners)) removeEventListener(type, listener as EventListener, true);
    };
  }, []);
  return over ? <div className="drop-hint">{refusal === undefined ? "Drop files here: documents, runs, or the coverage of tests" : `Only the coverage of tests is shown; nothing is stored: ${refusal}`}</div> : null;
}
