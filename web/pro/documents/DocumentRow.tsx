// A document in the list, with what can be done with it. What an action asks for, it asks for in the row.
import { useState } from "react";
import type { DocumentSummary } from "../../generated/messages";
import { freeDocumentName } from "../../shared/documents/names";
import { errorsText } from "../../shared/run/errorsText";
import { errorCount, refusalToStart } from "../../shared/session/draft";
import { useIsMaking } from "../../page/starting";
import { useRefusal } from "../login/rights";
import { CodeText } from "../panels/CodeText";
import { ProposalsOfDocument } from "../proposals/ProposalsButton";
import { download, downloadBundle, duplicate, edit, editWithHistory, makeRun, remove, showDocuments } from "./actions";
import { NameForm } from "./NameForm";
import { useAttempt } from "./useAttempt";

interface Props {
  readonly document: DocumentSummary;
  readonly taken: ReadonlySet<string>;
  /** Nothing can be done: the server is not there. */
  readonly offline: boolean;
}

export function DocumentRow({ document, taken, offline }: Props) {
  const { name, revision, doc } = document;
  const [asked, ask] = useState<"name" | "delete">();
  const { attempt, reason, busy } = useAttempt();
  const starting = useIsMaking();
  const disabled = offline || busy;
  const errors = errorCount(document);
  const mayRun = useRefusal("make_run");
  const refusal = mayRun ?? refusalToStart(document);
  const [mayBranch, mayDelete] = [useRefusal("branch_document"), useRefusal("delete_document")];
  const done = () => ask(undefined);
  return (
    <li className="document-row" aria-label={name}>
      <div className="document-head">
        <button type="button" className="document-name" disabled={offline} onClick={() => edit(name)}>
          {name}
        </button>
        <small>revision {revision}</small>
        <ProposalsOfDocument name={name} onShow={() => showDocuments(false)} />
        {errors > 0 && <span className="document-errors">draft, {errorsText(errors)}</span>}
      </div>
      {doc !== undefined && (
        <p className="document-doc">
          <CodeText text={doc} />
        </p>
      )}
      <div className="document-actions">
        <button type="button" disabled={disabled || starting || refusal !== undefined} title={refusal} onClick={() => void makeRun(name)}>
          New run
        </button>
        <button type="button" disabled={disabled || mayBranch !== undefined} title={mayBranch} aria-expanded={asked === "name"} onClick={() => ask("name")}>
          Duplicate
        </button>
        <button type="button" disabled={disabled} onClick={() => editWithHistory(name)}>
          History
        </button>
        <button type="button" disabled={disabled} onClick={() => void attempt(() => download(name))}>
          Download
        </button>
        <button type="button" disabled={disabled || errors > 0} title={errors > 0 ? "A draft is no bundle" : "A file for another server, with the interfaces of the services that it needs"} onClick={() => void attempt(() => downloadBundle(name))}>
          Bundle
        </button>
        <button type="button" disabled={disabled || mayDelete !== undefined} title={mayDelete} aria-expanded={asked === "delete"} onClick={() => ask("delete")}>
          Delete
        </button>
      </div>
      {asked === "name" && (
        <NameForm label="Name of the copy" does="Duplicate" wish={freeDocumentName(name, taken)} taken={taken} disabled={disabled} focus onName={(as) => void attempt(() => duplicate(name, as)).then(done)} onCancel={done} />
      )}
      {asked === "delete" && <AskDelete document={document} disabled={disabled} onDelete={() => void attempt(() => remove(name, revision)).then(done)} onCancel={done} />}
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </li>
  );
}

interface AskProps {
  readonly document: DocumentSummary;
  readonly disabled: boolean;
  readonly onDelete: () => void;
  readonly onCancel: () => void;
}

function AskDelete({ document: { name, revision }, disabled, onDelete, onCancel }: AskProps) {
  const loses = revision === 1 ? "It cannot be taken back." : `It goes with its ${revision} revisions and cannot be taken back.`;
  return (
    <div
      className="ask-delete"
      role="group"
      aria-label={`Delete ${name}?`}
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.preventDefault();
        event.stopPropagation();
        onCancel();
      }}
    >
      <span>
        Delete {name}? {loses} Its runs stay.
      </span>
      <button type="button" className="danger" disabled={disabled} onClick={onDelete}>
        Delete {name}
      </button>
      <button type="button" autoFocus onClick={onCancel}>
        Keep it
      </button>
    </div>
  );
}
