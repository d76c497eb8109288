// The files that are on their way to the server.
import { createUploading } from "../../shared/documents/uploading";
import { applyUpload, type Upload, type UploadEvent } from "../../shared/documents/uploads";
import { api, loadDocuments } from "../client";
import { author } from "../edit/author";
import { createStore, useSelected } from "../../page/store";

const uploads = createStore<readonly Upload[], UploadEvent>([], applyUpload);

export const useUploads = (): readonly Upload[] => useSelected(uploads, (all) => all);

export const { upload, sendAs, closeUpload, forgetStored } = createUploading(uploads, { api, author, loadDocuments });
