import { describe, expect, it } from "vitest";
import { RaceError } from "../../shared/api";
import { applyUpload, failed, kMostBytes, sizeText, type Upload } from "../../shared/documents/uploads";

const error = { path: "Root", code: "first", message: "there is no child `X`" };
const target = { name: "pick" };
const added = (size = 10): readonly Upload[] => applyUpload([], { type: "added", number: 1, file: "pick.rcm.json", size });

describe("a file that is uploaded", () => {
  it("is sent as a new document of its name, and stays with the answer until it is closed", () => {
    expect(added()).toEqual([{ number: 1, file: "pick.rcm.json", target, status: { kind: "sending" } }]);
    const stored = applyUpload(added(), { type: "answered", number: 1, status: { kind: "stored", revision: 1, errors: 0 } });
    expect(stored[0]?.status.kind).toBe("stored");
    expect([applyUpload(stored, { type: "closed", number: 1 }), applyUpload(stored, { type: "seen" }), applyUpload(added(), { type: "seen" })]).toEqual([[], [], added()]);
  });
  it("is not sent if the server would not take it, and the reason has both sizes", () => {
    expect(sizeText(kMostBytes + 1)).toBe("4.1 MiB");
    expect(added(kMostBytes)[0]?.status.kind).toBe("sending");
    expect(added(kMostBytes + 1024 * 1024)[0]?.status).toMatchObject({ kind: "refused", errors: [{ code: "too_large", message: "the file has 5 MiB; the server takes at most 4 MiB" }], next: "never" });
  });
  it("is a bundle by its name, and no draft if it has errors", () => {
    const bundle = applyUpload([], { type: "added", number: 1, file: "pick.bundle.json", size: 10 })[0]?.target;
    expect(bundle).toEqual({ name: "pick", bundle: true });
    expect(applyUpload([], { type: "added", number: 1, file: "pick.bundle (1).json", size: 10 })[0]?.target.bundle, "saved a second time").toBe(true);
    expect(applyUpload([], { type: "added", number: 1, file: "pick.json", size: 10, bundle: true })[0]?.target, "chosen as one").toEqual(bundle);
    expect(failed({ name: "pick", bundle: true }, new RaceError(422, [error], { moreErrors: false }))).toMatchObject({ next: "never" });
  });
  it("can be sent under another name, and others are as they were", () => {
    const two = applyUpload(added(), { type: "added", number: 2, file: "b.json", size: 1 });
    const taken = applyUpload(two, { type: "answered", number: 1, status: { kind: "taken" } });
    const again = applyUpload(taken, { type: "sent", number: 1, target: { name: "pick-2" } });
    expect(again.map(({ target: { name }, status }) => [name, status.kind])).toEqual([["pick-2", "sending"], ["b", "sending"]]);
  });
});

describe("a file that the server does not store", () => {
  const refused = (status: number, moreErrors = false) => new RaceError(status, [error], { moreErrors });
  it("has a name that is taken, or its document has gone on", () => expect([412, 409].map((status) => failed(target, refused(status)))).toEqual([{ kind: "taken" }, { kind: "taken" }]));
  it("can be a draft if it has errors of a document, once", () => {
    expect(failed(target, refused(422, true))).toEqual({ kind: "refused", errors: [error], more: true, next: "draft" });
    expect(failed({ ...target, draft: true }, refused(422))).toMatchObject({ next: "never" });
    expect(failed(target, refused(400))).toEqual({ kind: "refused", errors: [error], next: "never" });
  });
  it("can be sent again if the server cannot store it now, or is not there", () => {
    expect(failed(target, refused(507))).toMatchObject({ next: "again" });
    expect(failed(target, new TypeError("Failed to fetch"))).toMatchObject({ kind: "refused", errors: [{ message: "Failed to fetch" }], next: "again" });
  });
});
