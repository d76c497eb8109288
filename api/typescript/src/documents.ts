// Documents: tasks in RCM (core/SEMANTICS.md, section 1), with their revisions.
import { editDocument, deleteDocument, getDocument, getRevision, listDocuments, listRevisions, putDocument } from "./calls/documents.js";
import { RawJson, type Body } from "./call.js";
import { RaceError } from "./errors.js";
import type { Exact } from "./exact.js";
import type { AcceptedEdit, Document, DocumentEntry, DocumentRemoved, Documents as DocumentPage, DocumentSummary, Edit, EditRequest, Revisions, ServerError } from "./generated/messages.js";
import { newId } from "./newId.js";
import { sendTwice, tagOf, type Sender, type SendOptions } from "./sender.js";

/** A document has at most 100000 revisions. */
const kNoRevision = 2 ** 31 - 1;

export interface PutOptions extends SendOptions {
  /** Only if this is the last revision. */
  readonly ifRevision?: number | undefined;
  /** Only if there is no document of this name. */
  readonly isNew?: boolean | undefined;
  /** It may have violations, which the answer lists. */
  readonly draft?: boolean | undefined;
  readonly author?: string | undefined;
  /** Why it was changed. */
  readonly message?: string | undefined;
}

export interface EditOptions extends SendOptions {
  /** That the author has seen: what others have done since stays. */
  readonly revision: number;
  /** A token of the edit, else a new one. */
  readonly request?: string | undefined;
  readonly author?: string | undefined;
  readonly message?: string | undefined;
}

/** A document as a program has it; or its text, where numbers are to stay as they were written. */
const bodyOf = (document: object): Body<Document> => (document instanceof RawJson ? document : (document as Exact<Document>));

export class Documents {
  constructor(private readonly client: Sender) {}

  /** Each document by name: `name`, last `revision`, and how many `errors` it has (0: it can run). They come page by page. */
  async *all(options?: SendOptions): AsyncGenerator<DocumentSummary, void> {
    for (let after: string | undefined = ""; after !== undefined; ) {
      const page: DocumentPage = await this.client.send(listDocuments({ after }), options);
      yield* page.documents;
      after = page.next;
    }
  }

  /** The `document`, its `revision` (the last one, or the one asked for), who made it, and its `errors`. RaceError 404 `not_found`. */
  async get(name: string, { revision, ...options }: SendOptions & { readonly revision?: number | undefined } = {}): Promise<DocumentEntry> {
    return await this.client.send(revision === undefined ? getDocument(name) : getRevision(name, revision), options);
  }

  /**
   * Stores a document as the next revision, whole or not at all; the answer has it as it is stored, with ids. RaceError 412 `conflict`: a
   * condition does not hold; 422: violations, with path, code and message of each.
   */
  async put(name: string, document: object, { ifRevision, isNew = false, draft, author, message, ...options }: PutOptions = {}): Promise<DocumentEntry> {
    const conditions = { ifMatch: tagOf(ifRevision), ifNoneMatch: isNew ? "*" : undefined };
    return await this.client.send(putDocument(name, bodyOf(document), { draft, author, message, ...conditions }), options);
  }

  /**
   * The violations that the document has (none: it can be stored and run), 200 at most. Nothing is stored.
   *
   * The server checks a document before it looks at the condition under which it would store it: this asks for one that does not hold.
   * Needs the right to change documents. RaceError: it cannot be checked, such as 413 `too_large`.
   */
  async check(document: object, { name = "check", ...options }: SendOptions & { readonly name?: string } = {}): Promise<readonly ServerError[]> {
    try {
      await this.client.send(putDocument(name, bodyOf(document), { ifMatch: tagOf(kNoRevision) }), options);
    } catch (error) {
      if (error instanceof RaceError && error.status === 412) return [];
      if (error instanceof RaceError && error.status === 422) return error.errors;
      throw error;
    }
    throw new Error("the server has stored a document under a condition that does not hold");
  }

  /**
   * Applies operations (edit.json: insert, remove, move, set; elements by id), as a whole or not at all, also while it runs.
   *
   * RaceError 409 `conflict`: others changed the same thing; 422: an operation cannot be applied. An edit whose answer does not come is
   * sent again with its token, and made once. The answer has the new `revision`, and the violations (`errors`) that the document has then.
   */
  async edit(name: string, operations: Exact<Edit["operations"]>, options: EditOptions): Promise<AcceptedEdit> {
    const { revision, request = newId(), author, message, ...limits } = options;
    const body = { revision, request, operations, ...(author !== undefined && { author }), ...(message !== undefined && { message }) };
    return await sendTwice(this.client, editDocument(name, body as Exact<EditRequest>), limits);
  }

  /** Who changed it, when [ms since 1970, UTC] and why: 100 revisions, the newest first; `next` is `before` of the next page. */
  async revisions(name: string, { before, ...options }: SendOptions & { readonly before?: number | undefined } = {}): Promise<Revisions> {
    return await this.client.send(listRevisions(name, { before }), options);
  }

  /** Removes it with all revisions; its runs stay. RaceError 409 `conflict`: a run of it is not over; 412: `ifRevision` is not the last one. */
  async delete(name: string, { ifRevision, ...options }: SendOptions & { readonly ifRevision?: number | undefined } = {}): Promise<DocumentRemoved> {
    return await this.client.send(deleteDocument(name, { ifMatch: tagOf(ifRevision) }), options);
  }
}
