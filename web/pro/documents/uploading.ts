// The files that are on their way to the server.
import { applyUpload, failed, type Target, type Upload, type UploadEvent, type UploadStatus } from "../../shared/documents/uploads";
import { api, loadDocuments } from "../client";
import { author } from "../edit/author";
import { createStore, useSelected } from "../../page/store";

const uploads = createStore<readonly Upload[], UploadEvent>([], applyUpload);
const files = new Map<number, File>();
let lastNumber = 0;

export const useUploads = (): readonly Upload[] => useSelected(uploads, (all) => all);

/** Sends each file as a new document of its name. */
export function upload(chosen: Iterable<File>): void {
  for (const file of chosen) {
    const number = ++lastNumber;
    files.set(number, file);
    uploads.dispatch({ type: "added", number, file: file.name, size: file.size });
    const added = uploads.get().find((each) => each.number === number);
    if (added?.status.kind === "sending") void store(number, added.target);
  }
}

/** Sends a file again, as this. */
export function sendAs(number: number, target: Target): void {
  uploads.dispatch({ type: "sent", number, target });
  void store(number, target);
}

export function closeUpload(number: number): void {
  files.delete(number);
  uploads.dispatch({ type: "closed", number });
}

/** What is stored need not be told again. */
export const forgetStored = (): void => uploads.dispatch({ type: "seen" });

async function store(number: number, target: Target): Promise<void> {
  const file = files.get(number);
  if (file === undefined) return;
  try {
    uploads.dispatch({ type: "answered", number, status: await stored(file, target) });
  } catch (error) {
    uploads.dispatch({ type: "answered", number, status: failed(target, error) });
  }
  await loadDocuments();
}

async function stored(file: File, { name, bundle, ...how }: Target): Promise<UploadStatus> {
  if (bundle === true) {
    const { revision, lacking } = await api.installBundle(name, file, { ...how, author: author() });
    return { kind: "stored", revision, errors: 0, lacking };
  }
  const { revision, errors } = await api.putDocument(name, file, { ...how, author: author() });
  return { kind: "stored", revision, errors: errors.length };
}
