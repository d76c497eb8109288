// A file on its way to the server: what became of it, and what can be done if it could not be stored.
import type { DocumentSummary } from "../../generated/messages";
import { counted } from "../../shared/counted";
import { freeDocumentName } from "../../shared/documents/names";
import type { Upload } from "../../shared/documents/uploads";
import { countErrors, errorsText } from "../../shared/run/errorsText";
import { placeText } from "../../shared/session/draft";
import { CodeText } from "../panels/CodeText";
import { edit } from "./actions";
import { NameForm } from "./NameForm";
import { closeUpload, sendAs } from "./uploading";

interface Props {
  readonly upload: Upload;
  readonly documents: readonly DocumentSummary[];
  readonly taken: ReadonlySet<string>;
  readonly offline: boolean;
}

export function UploadRow({ upload, documents, taken, offline }: Props) {
  const { number, file, target, status } = upload;
  return (
    <li className={`upload-row is-${status.kind}`} aria-label={file}>
      <div className="upload-head">
        <strong>{file}</strong>
        <span role="status">{statusText(upload)}</span>
        {status.kind === "stored" && (
          <button type="button" disabled={offline} onClick={() => edit(target.name)}>
            Open
          </button>
        )}
        {status.kind !== "sending" && (
          <button type="button" className="upload-close" aria-label={`Close ${file}`} onClick={() => closeUpload(number)}>
            ✕
          </button>
        )}
      </div>
      {status.kind === "taken" && <Taken upload={upload} documents={documents} taken={taken} offline={offline} />}
      {status.kind === "stored" && status.lacking !== undefined && status.lacking.length > 0 && (
        <ul className="upload-lacking" aria-label={`What ${target.name} lacks`}>
          {status.lacking.map(({ path, message }) => (
            <li key={path}>
              <code>{path}</code> <CodeText text={message} />
            </li>
          ))}
        </ul>
      )}
      {status.kind === "refused" && (
        <>
          <ul className="upload-errors" aria-label={`Errors of ${file}`}>
            {status.errors.map((error, i) => (
              <li key={i}>
                <code>{placeText(error)}</code> <CodeText text={error.message} /> <small>{error.code}</small>
              </li>
            ))}
          </ul>
          {status.next !== "never" && (
            <div className="upload-actions">
              <button type="button" disabled={offline} onClick={() => sendAs(number, status.next === "draft" ? { ...target, draft: true } : target)}>
                {status.next === "draft" ? "Store as a draft" : "Try again"}
              </button>
            </div>
          )}
        </>
      )}
    </li>
  );
}

function Taken({ upload: { number, target }, documents, taken, offline }: Props) {
  const there = documents.find(({ name }) => name === target.name);
  return (
    <div className="upload-actions">
      <NameForm label="Store it as" does="Store" wish={freeDocumentName(target.name, taken)} taken={taken} disabled={offline} onName={(name) => sendAs(number, { ...target, name })} />
      {there !== undefined && (
        <button type="button" disabled={offline} onClick={() => sendAs(number, { ...target, onto: there.revision })}>
          Replace {there.name}, as revision {there.revision + 1}
        </button>
      )}
    </div>
  );
}

const lackingText = (lacking: readonly unknown[] = []): string => (lacking.length === 0 ? "" : `, lacks ${counted(lacking.length, "service")}`);

function statusText({ target: { name, onto }, status }: Upload): string {
  switch (status.kind) {
    case "sending":
      return `Storing it as ${name}…`;
    case "stored":
      return `Stored as ${name}, revision ${status.revision}${status.errors === 0 ? "" : `, a draft with ${errorsText(status.errors)}`}${lackingText(status.lacking)}`;
    case "taken":
      return onto === undefined ? `There is a document ${name}.` : `${name} was changed meanwhile.`;
    case "refused":
      return `Not stored: ${errorsText(countErrors(status.errors, status.more))}`;
  }
}
