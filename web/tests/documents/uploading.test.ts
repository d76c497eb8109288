import { describe, expect, it, vi } from "vitest";
import { RaceError } from "../../shared/api";
import { createUploading, type ChosenFile } from "../../shared/documents/uploading";
import { applyUpload, type Upload, type UploadEvent } from "../../shared/documents/uploads";
import { createStore } from "../../shared/store";

const file = (name: string): ChosenFile => Object.assign(new Blob(["{}"]), { name });
const lacking = [{ path: "lamp", code: "not_found", message: "there is no service of this key here" }];

function page() {
  const uploads = createStore<readonly Upload[], UploadEvent>([], applyUpload, () => () => undefined);
  const api = {
    putDocument: vi.fn(() => Promise.reject(new Error("it is no document"))),
    installBundle: vi.fn((name: string) =>
      name === "pick" ? Promise.reject(new RaceError(409, [{ path: "", code: "conflict", message: "there is one" }], { moreErrors: false })) : Promise.resolve({ name, revision: 1, lacking }),
    ),
  };
  const loadDocuments = vi.fn(() => Promise.resolve());
  return { uploads, api, loadDocuments, ...createUploading(uploads, { api, author: () => "ann", loadDocuments }) };
}

describe("files that a person sends", () => {
  it("are bundles if they were chosen as such, and under another name if theirs is taken", async () => {
    const { uploads, api, loadDocuments, upload, sendAs, forgetStored } = page();
    upload([file("pick.json")], { bundle: true });
    await vi.waitFor(() => expect(uploads.get()[0]?.status).toEqual({ kind: "taken" }));
    sendAs(1, { name: "pick-2", bundle: true });
    expect(uploads.get()[0]?.status).toEqual({ kind: "sending" });
    await vi.waitFor(() => expect(loadDocuments).toHaveBeenCalledTimes(2));
    expect(uploads.get()[0]?.status).toEqual({ kind: "stored", revision: 1, errors: 0, lacking });
    expect([api.installBundle.mock.calls.length, api.putDocument.mock.calls.length]).toEqual([2, 0]);
    forgetStored();
    expect(uploads.get()).toEqual([]);
  });

  it("are not sent once they are closed, and their numbers are not used again", async () => {
    const { uploads, api, upload, closeUpload, sendAs } = page();
    upload([file("a.json"), file("b.json")]);
    await vi.waitFor(() => expect(uploads.get().map(({ status }) => status.kind)).toEqual(["refused", "refused"]));
    closeUpload(1);
    sendAs(1, { name: "a" });
    expect(api.putDocument).toHaveBeenCalledTimes(2);
    upload([file("c.json")]);
    expect(uploads.get().map(({ number }) => number)).toEqual([2, 3]);
  });
});
