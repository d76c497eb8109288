// Routes of api/openapi.yaml: documents. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Body, type Call } from "../call.js";
import type { AcceptedEdit, Bundle, Document, DocumentBranch, DocumentBreakpoints, DocumentEntry, DocumentRemoved, DocumentRestore, Documents, EditRequest, Native, Proposal, ProposalRequest, Revisions } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * The documents and drafts of the server, by name.
 *
 * after: Only names after this one: `next` of the answer before.
 *
 * limit: How many at most.
 *
 * 400: A parameter is out of its range (`out_of_range`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const listDocuments = (
  options: { readonly after?: string | undefined; readonly limit?: number | undefined } = {},
): Call<Documents> => ({
  method: "GET",
  path: "/api/v1/documents",
  query: { after: options.after, limit: options.limit },
  answer: schema.documents,
});

/**
 * One document or draft as it is edited, with links and oracles, and every violation.
 *
 * name: Of a document.
 *
 * ifNoneMatch: Tags of revisions that the client has, or `*`. After a restored backup a revision may be another one.
 *
 * 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 422: It was stored by an earlier version of the server and is no draft any more; every violation.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getDocument = (name: string, options: { readonly ifNoneMatch?: string | undefined } = {}): Call<DocumentEntry> => ({
  method: "GET",
  path: `/api/v1/documents/${segment(name)}`,
  headers: { "If-None-Match": options.ifNoneMatch },
  answer: schema.documentEntry,
});

/**
 * Stores a document under a name, as the next revision. Refused whole, with every violation, if it breaks a constraint and is no
 * draft.
 *
 * What is stored, and answered, may differ from what was sent (core/SEMANTICS.md section 1): an element without id gets the one
 * that the element at its place had in the last revision, else a new one; of elements with the same id, all but one get new ones;
 * and keys of `layout` that are paths become ids. A draft whose shape is wrong is kept as it was sent. What is the same as the
 * last revision is that revision.
 *
 * name: Of a document.
 *
 * draft: It may have violations, which the answer lists; any object will do.
 *
 * message: Why it was changed.
 *
 * revision: The last revision that the author has seen: if there is a later one, the answer is 409.
 *
 * ifMatch: The strong tag of a revision: nothing is changed unless that is the last one.
 *
 * ifNoneMatch: There must be no document of this name.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or a parameter is none (`out_of_range`); or the document
 * with its ids would be too deep to be read again (`too_deep`).
 *
 * 409: `conflict`: `revision` is not the last one.
 *
 * 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that there is
 * none.
 *
 * 413: With its links it has too many states, or its text with the ids would be too large to be read again; the author or message
 * is too long; there are 10000 documents or 100000 revisions of it (`too_large`).
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const putDocument = (
  name: string,
  body: Body<Document>,
  options: { readonly draft?: boolean | undefined; readonly author?: string | undefined; readonly message?: string | undefined; readonly revision?: number | undefined; readonly ifMatch?: string | undefined; readonly ifNoneMatch?: string | undefined } = {},
): Call<DocumentEntry> => ({
  method: "PUT",
  path: `/api/v1/documents/${segment(name)}`,
  query: { draft: options.draft, author: options.author, message: options.message, revision: options.revision },
  headers: { "If-Match": options.ifMatch, "If-None-Match": options.ifNoneMatch },
  body,
  answer: schema.documentEntry,
});

/**
 * Removes a document or draft with all its revisions, also a damaged one. Its runs stay.
 *
 * A core that has executed it keeps what it executes. A document that is stored under the same name later goes on after the last
 * revision of this one. For who follows it on the stream, it ends with `not_found`.
 *
 * name: Of a document.
 *
 * ifMatch: The strong tag of a revision: nothing is changed unless that is the last one.
 *
 * 400: A parameter is out of its range (`out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: A core has it whose run is not over, or the boot list (`conflict`).
 *
 * 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that there is
 * none.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const deleteDocument = (name: string, options: { readonly ifMatch?: string | undefined } = {}): Call<DocumentRemoved> => ({
  method: "DELETE",
  path: `/api/v1/documents/${segment(name)}`,
  headers: { "If-Match": options.ifMatch },
  answer: schema.documentRemoved,
});

/**
 * Edits a document or draft as it is now, whatever others have done since its author saw it; undo and redo by author.
 *
 * Whoever is subscribed to the channel document/{name} of the stream hears of it. An edit may leave violations, which the answer
 * lists. A draft whose shape is wrong cannot be edited.
 *
 * name: Of a document.
 *
 * ifMatch: The strong tag of a revision: the edit is made only if that is the last one. Stands for `revision`, if that is absent.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`); the document would be too deep to be read again
 * (`too_deep`); there is no such revision, or If-Match is none (`out_of_range`); neither says a revision (`missing`); the
 * document that is stored is no draft.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: `conflict`: others have changed the same thing since, and the message says who, in which revision; or the shape of the
 * draft is wrong.
 *
 * 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that there is
 * none.
 *
 * 413: The author or message is too long, there are too many operations, the document would become too large, or it has 100000
 * revisions (`too_large`).
 *
 * 422: The request does not fit its schema; an operation cannot be applied, or a compound edit cannot be made, for the reason
 * that its errors say; there is nothing to undo or redo (`not_found`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const editDocument = (
  name: string,
  body: Body<EditRequest>,
  options: { readonly ifMatch?: string | undefined } = {},
): Call<AcceptedEdit> => ({
  method: "POST",
  path: `/api/v1/documents/${segment(name)}/edits`,
  headers: { "If-Match": options.ifMatch },
  body,
  answer: schema.acceptedEdit,
});

/**
 * Who changed a document, when and why; the newest revision first.
 *
 * name: Of a document.
 *
 * before: Only revisions before this one.
 *
 * 400: A parameter is out of its range (`out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const listRevisions = (
  name: string,
  options: { readonly before?: number | undefined; readonly limit?: number | undefined } = {},
): Call<Revisions> => ({
  method: "GET",
  path: `/api/v1/documents/${segment(name)}/revisions`,
  query: { before: options.before, limit: options.limit },
  answer: schema.revisions,
});

/**
 * A document as it was in a revision; its violations are those that it has today.
 *
 * name: Of a document.
 *
 * revision: Of the document.
 *
 * ifNoneMatch: Tags of revisions that the client has, or `*`. After a restored backup a revision may be another one.
 *
 * 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 422: It was stored by an earlier version of the server and is no draft any more; every violation.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getRevision = (
  name: string,
  revision: number,
  options: { readonly ifNoneMatch?: string | undefined } = {},
): Call<DocumentEntry> => ({
  method: "GET",
  path: `/api/v1/documents/${segment(name)}/revisions/${segment(revision)}`,
  headers: { "If-None-Match": options.ifNoneMatch },
  answer: schema.documentEntry,
});

/**
 * Makes the text of an earlier revision the next one. What is the same as the last revision is that revision.
 *
 * name: Of a document.
 *
 * ifMatch: The strong tag of a revision: nothing is changed unless that is the last one.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`), or If-Match is no tag of a revision
 * (`out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that there is
 * none.
 *
 * 413: The author or message is too long, or it has 100000 revisions (`too_large`).
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const restoreDocument = (
  name: string,
  body: Body<DocumentRestore>,
  options: { readonly ifMatch?: string | undefined } = {},
): Call<DocumentEntry> => ({
  method: "POST",
  path: `/api/v1/documents/${segment(name)}/restore`,
  headers: { "If-Match": options.ifMatch },
  body,
  answer: schema.documentEntry,
});

/**
 * Makes a revision the first one of a document of its own. Its elements keep their ids.
 *
 * name: Of a document.
 *
 * idempotencyKey: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
 * the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
 * requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
 * 409 (`conflict`). The last 1000 answers are kept, while the server runs.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: `conflict`: there is a document of this name.
 *
 * 413: The author or message is too long, or there are 10000 documents (`too_large`).
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const branchDocument = (
  name: string,
  body: Body<DocumentBranch>,
  options: { readonly idempotencyKey?: string | undefined } = {},
): Call<DocumentEntry> => ({
  method: "POST",
  path: `/api/v1/documents/${segment(name)}/branch`,
  headers: { "Idempotency-Key": options.idempotencyKey },
  body,
  answer: schema.documentEntry,
});

/**
 * The breakpoints that a person keeps at a document; none if they have never set any, or there is no such document.
 *
 * name: Of a document.
 *
 * author: Whose they are: the name of a person.
 *
 * 413: `too_large`: the author has more than 100 characters.
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getDocumentBreakpoints = (name: string, options: { readonly author: string }): Call<DocumentBreakpoints> => ({
  method: "GET",
  path: `/api/v1/documents/${segment(name)}/breakpoints`,
  query: { author: options.author },
  answer: schema.documentBreakpoints,
});

/**
 * Replaces the breakpoints that a person keeps at a document, until it is removed.
 *
 * They change no core: a client gives them to the cores that it lets go (PUT cores/{id}/breakpoints?author=). Of more than 100
 * people at a document, who has set theirs longest ago loses them.
 *
 * name: Of a document.
 *
 * author: Whose they are: the name of a person.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 413: `too_large`: there are more than 100, or a text is too long.
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const putDocumentBreakpoints = (
  name: string,
  body: Body<DocumentBreakpoints>,
  options: { readonly author: string },
): Call<DocumentBreakpoints> => ({
  method: "PUT",
  path: `/api/v1/documents/${segment(name)}/breakpoints`,
  query: { author: options.author },
  body,
  answer: schema.documentBreakpoints,
});

/**
 * The document translated to what executes (no links, no oracles), and where each element came from.
 *
 * name: Of a document.
 *
 * 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 422: It is a draft; every violation.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getDocumentNative = (name: string): Call<Native> => ({
  method: "GET",
  path: `/api/v1/documents/${segment(name)}/native`,
  answer: schema.native,
});

/**
 * The document as a bundle, with the interfaces of the services that it needs, as they are here.
 *
 * What it calls by `svc[...]` is not known. POST bundles installs it elsewhere.
 *
 * name: Of a document.
 *
 * 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 422: It is a draft; every violation.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getDocumentBundle = (name: string): Call<Bundle> => ({
  method: "GET",
  path: `/api/v1/documents/${segment(name)}/bundle`,
  answer: schema.bundle,
});

/**
 * Proposes a change of a document, or a new one. It changes nothing until somebody who may change documents accepts it.
 *
 * Who may not change documents proposes; who may does not need to. The document is checked as one that is put: it must have no
 * violations, and is kept with ids. At most 100 proposals are open, 20 of an author, with documents of at most 64 MiB, 32 MiB of
 * an author; of those that are decided, the last 200 are kept, with documents of at most 64 MiB. The channel `proposals` of the
 * stream tells of them.
 *
 * name: Of a document.
 *
 * author: Who does it: their account, or one of their pages, `NAME~...`; absent: the account.
 *
 * idempotencyKey: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
 * the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
 * requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
 * 409 (`conflict`). The last 1000 answers are kept, while the server runs.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`), or the document with its ids would be too
 * deep to be read again (`too_deep`).
 *
 * 409: `conflict`: `revision` is not the last one; or it says none, and there is a document of this name.
 *
 * 413: With its links the document has too many states, or its text with the ids would be too large to be read again; the note is
 * too long; too many proposals are open, or too large ones, in all or of this author (`too_large`).
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const proposeDocument = (
  name: string,
  body: Body<ProposalRequest>,
  options: { readonly author?: string | undefined; readonly idempotencyKey?: string | undefined } = {},
): Call<Proposal> => ({
  method: "POST",
  path: `/api/v1/documents/${segment(name)}/proposals`,
  query: { author: options.author },
  headers: { "Idempotency-Key": options.idempotencyKey },
  body,
  answer: schema.proposal,
});
