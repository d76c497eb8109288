// Files that become documents, as a value: each with what the server has said of it, until the user closes it.
import type { ServerError } from "../../generated/messages";
import { assertNever } from "../assertNever";
import { isRefusal } from "../api";
import { isBundleFile, nameOfFile } from "./names";
import { messageOf } from "../messageOf";

/** The server takes no larger body [byte]. */
export const kMostBytes = 4 * 1024 * 1024;

/** As what a file is sent. */
export interface Target {
  readonly name: string;
  /** The revision that it follows; nothing: it is a new document. */
  readonly onto?: number;
  /** It is stored although it has errors. */
  readonly draft?: true;
  /** It is a bundle, which is stored without errors or not at all. */
  readonly bundle?: true;
}

export type UploadStatus =
  | { readonly kind: "sending" }
  /** `lacking`: what services lack that it needs, by their keys. */
  | { readonly kind: "stored"; readonly revision: number; readonly errors: number; readonly lacking?: readonly ServerError[] }
  /** There is such a document, or another revision of it than `onto`. */
  | { readonly kind: "taken" }
  /** `draft`: it can be stored with these errors; `again`: the same may be stored another time; `never`: it cannot. */
  | { readonly kind: "refused"; readonly errors: readonly ServerError[]; readonly more?: true; readonly next: "draft" | "again" | "never" };

export interface Upload {
  readonly number: number;
  readonly file: string;
  readonly target: Target;
  readonly status: UploadStatus;
}

export type UploadEvent =
  /** `bundle`: it is one, whatever it is called. */
  | { readonly type: "added"; readonly number: number; readonly file: string; readonly size: number; readonly bundle?: true }
  | { readonly type: "sent"; readonly number: number; readonly target: Target }
  | { readonly type: "answered"; readonly number: number; readonly status: UploadStatus }
  | { readonly type: "closed"; readonly number: number }
  /** The user has seen what is stored. */
  | { readonly type: "seen" };

/** "4 MiB", "12.3 MiB": rounded up, so that what is too large looks so. */
export const sizeText = (bytes: number): string => `${Math.ceil((bytes / 1024 / 1024) * 10) / 10} MiB`;

function tooLarge(size: number): UploadStatus {
  return { kind: "refused", next: "never", errors: [{ path: "", code: "too_large", message: `the file has ${sizeText(size)}; the server takes at most ${sizeText(kMostBytes)}` }] };
}

export function applyUpload(uploads: readonly Upload[], event: UploadEvent): readonly Upload[] {
  const change = (number: number, changed: Partial<Upload>) => uploads.map((upload) => (upload.number === number ? { ...upload, ...changed } : upload));
  switch (event.type) {
    case "added": {
      const status: UploadStatus = event.size > kMostBytes ? tooLarge(event.size) : { kind: "sending" };
      return [...uploads, { number: event.number, file: event.file, target: { name: nameOfFile(event.file), ...((event.bundle ?? isBundleFile(event.file)) && { bundle: true }) }, status }];
    }
    case "sent":
      return change(event.number, { target: event.target, status: { kind: "sending" } });
    case "answered":
      return change(event.number, { status: event.status });
    case "closed":
      return uploads.filter(({ number }) => number !== event.number);
    case "seen":
      return uploads.filter(({ status }) => status.kind !== "stored");
    default:
      return assertNever(event);
  }
}

/** What an attempt to store `target` says that has failed. */
export function failed(target: Target, error: unknown): UploadStatus {
  if (!isRefusal(error)) {
    const message = messageOf(error);
    return { kind: "refused", errors: [{ path: "", code: "unavailable", message }], next: "again" };
  }
  const { status, errors, moreErrors } = error;
  if (status === 412 || status === 409) return { kind: "taken" };
  const next = status >= 500 ? "again" : status === 422 && target.draft === undefined && target.bundle === undefined ? "draft" : "never";
  return { kind: "refused", errors, ...(moreErrors && { more: true }), next };
}
