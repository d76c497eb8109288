// What is done with documents as a whole. Each action loads the list anew.
import type { Document } from "../../generated/messages";
import { fieldText } from "../../shared/documents/entryText";
import { bundleFileOf, fileOf, newDocumentText } from "../../shared/documents/names";
import { api, loadDocuments, view } from "../client";
import { author } from "../edit/author";
import { closeDocument, editing, openDocument } from "../edit/editing";
import { saveText } from "../saveText";
import { showHistory } from "../versions/history";
import { showHelp } from "../help/help";
import { requestRun } from "./asking";

/** Closes the panel and shows the document in the editor. */
export function edit(name: string): void {
  showDocuments(false);
  openDocument(name);
}

/** The same, with its history. */
export function editWithHistory(name: string): void {
  edit(name);
  showHistory(true);
}

export function showDocuments(shown: boolean): void {
  view.dispatch({ type: "documents", shown });
}

/** Makes a run, ready to be started, and shows it. */
export async function makeRun(name: string): Promise<void> {
  showDocuments(false);
  view.dispatch({ type: "page", page: "task" });
  await requestRun(name, false);
}

/** An empty document, open in the editor: also one that is open there and did not exist. */
export async function create(name: string): Promise<void> {
  await api.putDocument(name, newDocumentText(name), { author: author() });
  await loadDocuments();
  if (editing.get().document === name) closeDocument();
  edit(name);
}

/** A document with this content, open in the editor. */
export async function createFrom(name: string, content: Document): Promise<void> {
  await api.putDocument(name, JSON.stringify(content), { author: author() });
  await loadDocuments();
  showHelp(undefined);
  edit(name);
}

export async function duplicate(name: string, as: string): Promise<void> {
  await api.branchDocument(name, as, author());
  await loadDocuments();
}

export async function remove(name: string, revision: number): Promise<void> {
  try {
    await api.deleteDocument(name, revision);
    if (editing.get().document !== name) return;
    closeDocument();
    view.dispatch({ type: "page", page: "task" });
  } finally {
    await loadDocuments();
  }
}

/** Saves the document as a file, as the server has written it. */
export async function download(name: string): Promise<void> {
  const text = fieldText(await api.documentText(name), "document") ?? "";
  saveText(fileOf(name), "application/json", text);
}

/** The same with the interfaces of the services that it needs, for another server. */
export async function downloadBundle(name: string): Promise<void> {
  saveText(bundleFileOf(name), "application/json", await api.bundleText(name));
}
