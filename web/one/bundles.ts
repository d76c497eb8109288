// The bundles that are installed from this page.
import { createStore, useSelected } from "../page/store";
import { createUploading } from "../shared/documents/uploading";
import { applyUpload, type Upload, type UploadEvent } from "../shared/documents/uploads";
import { api, loadDocuments } from "./client";
import { author } from "./own";

const uploads = createStore<readonly Upload[], UploadEvent>([], applyUpload);

export const useBundles = (): readonly Upload[] => useSelected(uploads, (all) => all);

export const { upload, sendAs, closeUpload, forgetStored } = createUploading(uploads, { api, author, loadDocuments });
