// Applications that come as files of another server: the button that installs them, and what became of each.
import { useEffect } from "react";
import { FileButton } from "../page/FileButton";
import { CodeText } from "../pro/panels/CodeText";
import { namesOf } from "../shared/documents/listed";
import { freeDocumentName } from "../shared/documents/names";
import type { Upload } from "../shared/documents/uploads";
import { closeUpload, forgetStored, sendAs, upload, useBundles } from "./bundles";
import { useRefusal, useSession } from "./client";
import { go } from "./place";
import { texts } from "./texts";

const t = texts.bundles;

export function Bundles() {
  const refusal = useRefusal("store_document");
  const offline = useSession((s) => s.connection !== "open");
  const bundles = useBundles();
  useEffect(() => forgetStored, []);
  return (
    <section className="bundles" aria-label={t.title}>
      <FileButton name={t.files} multiple disabled={offline || refusal !== undefined} title={refusal ?? t.about} onFiles={(files) => upload(files, { bundle: true })}>
        {t.install}
      </FileButton>
      {bundles.length > 0 && (
        <ul aria-label={t.title}>
          {bundles.map((bundle) => (
            <BundleRow key={bundle.number} bundle={bundle} offline={offline} />
          ))}
        </ul>
      )}
    </section>
  );
}

function BundleRow({ bundle, offline }: { readonly bundle: Upload; readonly offline: boolean }) {
  const { number, file, target, status } = bundle;
  const documents = useSession((s) => s.documents);
  const free = freeDocumentName(target.name, namesOf(documents));
  const said = status.kind === "stored" ? (status.lacking ?? []) : status.kind === "refused" ? status.errors : [];
  return (
    <li className={`bundle is-${status.kind}`} aria-label={file}>
      <p role="status">{statusText(bundle)}</p>
      {status.kind === "stored" && (
        <button type="button" disabled={offline} onClick={() => go({ edit: target.name, view: "build" })}>
          {t.open}
        </button>
      )}
      {status.kind === "taken" && (
        <button type="button" disabled={offline} onClick={() => sendAs(number, { ...target, name: free })}>
          {t.installAs(free)}
        </button>
      )}
      {status.kind === "refused" && status.next === "again" && (
        <button type="button" disabled={offline} onClick={() => sendAs(number, target)}>
          {texts.tryAgain}
        </button>
      )}
      {status.kind !== "sending" && (
        <button type="button" className="plain" aria-label={t.close(file)} onClick={() => closeUpload(number)}>
          ✕
        </button>
      )}
      {said.length > 0 && (
        <ul aria-label={status.kind === "stored" ? t.lacking(target.name) : t.errors(file)}>
          {said.map(({ path, message }, i) => (
            <li key={i}>
              {path !== "" && <strong>{path}: </strong>}
              <CodeText text={message} />
            </li>
          ))}
        </ul>
      )}
    </li>
  );
}

function statusText({ file, target: { name }, status }: Upload): string {
  switch (status.kind) {
    case "sending":
      return t.installing(name);
    case "stored":
      return t.installed(name, status.lacking?.length ?? 0);
    case "taken":
      return t.taken(name);
    case "refused":
      return t.refused(file);
  }
}
