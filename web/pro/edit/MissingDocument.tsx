// The address names a document that is not there: what may have happened, and the ways on.
import { nameRefusal } from "../../shared/documents/names";
import { useSession } from "../client";
import { create, showDocuments } from "../documents/actions";
import { useRefusal } from "../login/rights";
import { useAttempt } from "../documents/useAttempt";

const kNone: ReadonlySet<string> = new Set();

export function MissingDocument({ document }: { readonly document: string }) {
  const offline = useSession((s) => s.connection !== "open");
  const { attempt, reason, busy } = useAttempt();
  const refusal = nameRefusal(document, kNone);
  const mayStore = useRefusal("store_document");
  return (
    <section className="missing-document" aria-label="No such document">
      <h2>There is no document {document}.</h2>
      <p>It was deleted, or the link names another server or is written wrongly.</p>
      <div>
        <button type="button" disabled={offline || busy || refusal !== undefined || mayStore !== undefined} title={mayStore} onClick={() => void attempt(() => create(document))}>
          New document of this name
        </button>
        <button type="button" onClick={() => showDocuments(true)}>
          All documents
        </button>
      </div>
      {refusal !== undefined && <p>None can have this name. {refusal}</p>}
      {reason !== undefined && (
        <p className="bad" role="alert">
          Not made: {reason}
        </p>
      )}
    </section>
  );
}
