// The documents of the server, over the page: opened with Ctrl+O or the button of the top bar, closed with Esc.
import { useEffect, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { FileButton } from "../../page/FileButton";
import { matching, namesOf } from "../../shared/documents/listed";
import { freeDocumentName } from "../../shared/documents/names";
import { kMostBytes, sizeText } from "../../shared/documents/uploads";
import { loadDocuments, useSession, useView } from "../client";
import { useRefusal } from "../login/rights";
import { create, edit, showDocuments } from "./actions";
import { DocumentRow } from "./DocumentRow";
import { NameForm } from "./NameForm";
import { UploadRow } from "./UploadRow";
import { forgetStored, upload, useUploads } from "./uploading";
import { useAttempt } from "./useAttempt";

export function DocumentsPanel() {
  const shown = useView((v) => v.documents);
  return shown ? <Panel /> : null;
}

const close = () => showDocuments(false);

/** The list is as it is on the server now. */
function useFreshList(): void {
  useEffect(() => {
    const load = () => void loadDocuments();
    load();
    addEventListener("focus", load);
    return () => {
      removeEventListener("focus", load);
      forgetStored();
    };
  }, []);
}

/** From the search down through the names, and up again. */
function moveByArrow(event: KeyboardEvent<HTMLElement>): void {
  const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
  const stops = [...event.currentTarget.querySelectorAll<HTMLElement>("input[type=search], .document-name")];
  const at = stops.findIndex((stop) => stop === event.target);
  if (by === 0 || at < 0) return;
  event.preventDefault();
  stops[at + by]?.focus();
}

function Panel() {
  const dialog = useRef<HTMLDialogElement>(null);
  const search = useRef<HTMLInputElement>(null);
  useEffect(() => {
    dialog.current?.showModal();
    search.current?.focus();
  }, []);
  useFreshList();
  const [query, setQuery] = useState("");
  const documents = useSession((s) => s.documents);
  const offline = useSession((s) => s.connection !== "open");
  const taken = useMemo(() => namesOf(documents), [documents]);
  const hits = useMemo(() => matching(documents, query), [documents, query]);
  const uploads = useUploads();
  return (
    <dialog ref={dialog} className="documents" aria-label="Documents" onClose={close} onClick={(event) => event.target === event.currentTarget && close()}>
      <div className="documents-body" onKeyDown={moveByArrow}>
        <div className="documents-head">
          <h2>Documents</h2>
          <button type="button" aria-label="Close" onClick={close}>
            ✕
          </button>
        </div>
        <Making taken={taken} offline={offline}>
          <input
            ref={search}
            type="search"
            placeholder="Search names and descriptions"
            aria-label="Search the documents"
            value={query}
            onChange={(event) => setQuery(event.target.value)}
            onKeyDown={(event) => event.key === "Enter" && hits[0] !== undefined && !offline && edit(hits[0].name)}
          />
        </Making>
        {offline && (
          <p className="documents-offline" role="status">
            The server is not there: nothing can be opened or stored until it answers again.
          </p>
        )}
        {uploads.length > 0 && (
          <ul className="uploads" aria-label="Uploads">
            {uploads.map((each) => (
              <UploadRow key={each.number} upload={each} documents={documents} taken={taken} offline={offline} />
            ))}
          </ul>
        )}
        <ul className="document-list" aria-label="Documents of the server">
          {hits.map((document) => (
            <DocumentRow key={document.name} document={document} taken={taken} offline={offline} />
          ))}
        </ul>
        {hits.length === 0 && <p className="documents-none">{documents.length === 0 ? "There are no documents yet. Make a new one, or drop a file here." : `No document has ${query} in its name or description.`}</p>}
      </div>
    </dialog>
  );
}

interface MakingProps {
  readonly taken: ReadonlySet<string>;
  readonly offline: boolean;
  readonly children: React.ReactNode;
}

/** The search, and how a document comes to be: by a name, or from a file. */
function Making({ taken, offline, children }: MakingProps) {
  const [asked, ask] = useState(false);
  const { attempt, reason, busy } = useAttempt();
  const refusal = useRefusal("store_document");
  return (
    <section className="making" aria-label="New documents">
      <div className="making-tools">
        {children}
        <button type="button" disabled={offline || refusal !== undefined} title={refusal} aria-expanded={asked} onClick={() => ask(!asked)}>
          New
        </button>
        <FileButton name="Files to upload" multiple disabled={offline || refusal !== undefined} title={refusal ?? `Or drop files anywhere on the page; at most ${sizeText(kMostBytes)} each`} onFiles={(files) => upload(files)}>
          Upload
        </FileButton>
      </div>
      <p className="quiet">{refusal === undefined ? `Files can be dropped anywhere on the page, each of at most ${sizeText(kMostBytes)}.` : `You cannot store documents: ${refusal}.`}</p>
      {asked && <NameForm label="Name" does="Create" wish={freeDocumentName("task", taken)} taken={taken} disabled={offline || busy} focus onName={(name) => void attempt(() => create(name))} onCancel={() => ask(false)} />}
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </section>
  );
}
