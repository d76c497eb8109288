// Sends files that become documents, and keeps of each what the server says.
import type { Api } from "../api";
import type { Store } from "../store";
import { failed, type Target, type Upload, type UploadEvent, type UploadStatus } from "./uploads";

/** As a page gets it of a person. */
export type ChosenFile = Blob & { readonly name: string };

export interface UploadServer {
  readonly api: Pick<Api, "installBundle" | "putDocument">;
  /** Who changes documents on this page. */
  readonly author: () => string;
  /** Once a file is stored, or is not. */
  readonly loadDocuments: () => Promise<unknown>;
}

export interface Uploading {
  /** Sends each file as a new document of its name. `bundle`: each is one, whatever it is called. */
  readonly upload: (chosen: Iterable<ChosenFile>, how?: { readonly bundle?: true }) => void;
  /** Sends a file again, as this. */
  readonly sendAs: (number: number, target: Target) => void;
  readonly closeUpload: (number: number) => void;
  /** What is stored need not be told again. */
  readonly forgetStored: () => void;
}

/** `uploads` holds what is known of each file until it is closed. */
export function createUploading(uploads: Store<readonly Upload[], UploadEvent>, { api, author, loadDocuments }: UploadServer): Uploading {
  const files = new Map<number, ChosenFile>();
  let lastNumber = 0;

  async function stored(file: ChosenFile, { name, bundle, ...how }: Target): Promise<UploadStatus> {
    if (bundle === true) {
      const { revision, lacking } = await api.installBundle(name, file, { ...how, author: author() });
      return { kind: "stored", revision, errors: 0, lacking };
    }
    const { revision, errors } = await api.putDocument(name, file, { ...how, author: author() });
    return { kind: "stored", revision, errors: errors.length };
  }

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

  return {
    upload(chosen, how) {
      for (const file of chosen) {
        const number = ++lastNumber;
        files.set(number, file);
        uploads.dispatch({ type: "added", number, file: file.name, size: file.size, ...how });
        const added = uploads.get().find((each) => each.number === number);
        if (added?.status.kind === "sending") void store(number, added.target);
      }
    },
    sendAs(number, target) {
      uploads.dispatch({ type: "sent", number, target });
      void store(number, target);
    },
    closeUpload(number) {
      files.delete(number);
      uploads.dispatch({ type: "closed", number });
    },
    forgetStored: () => uploads.dispatch({ type: "seen" }),
  };
}
