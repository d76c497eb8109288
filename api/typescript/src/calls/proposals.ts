// Routes of api/openapi.yaml: proposals. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Body, type Call } from "../call.js";
import type { Proposal, ProposalDecline, Proposals } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * Proposed changes of documents, the oldest first; of those that are decided, the last ones.
 *
 * document: Only those of this document.
 *
 * status: Only those with this status.
 *
 * after: Only those after this one: `next` of the answer before.
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
export const listProposals = (
  options: { readonly document?: string | undefined; readonly status?: string | undefined; readonly after?: string | undefined; readonly limit?: number | undefined } = {},
): Call<Proposals> => ({
  method: "GET",
  path: "/api/v1/proposals",
  query: { document: options.document, status: options.status, after: options.after, limit: options.limit },
  answer: schema.proposals,
});

/**
 * One proposal, with the document that it proposes.
 *
 * id: Of a proposal.
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
export const getProposal = (id: string): Call<Proposal> => ({
  method: "GET",
  path: `/api/v1/proposals/${segment(id)}`,
  answer: schema.proposal,
});

/**
 * Withdraws an open proposal. For its author, and for who may change documents.
 *
 * id: Of a proposal.
 *
 * author: Who does it: their account, or one of their pages, `NAME~...`; absent: the account.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: `conflict`: it was decided before.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const withdrawProposal = (id: string, options: { readonly author?: string | undefined } = {}): Call<Proposal> => ({
  method: "DELETE",
  path: `/api/v1/proposals/${segment(id)}`,
  query: { author: options.author },
  answer: schema.proposal,
});

/**
 * Makes a proposal the next revision of its document.
 *
 * The author of the revision is who accepts it; its origin names who has proposed it, and its message is the note. A proposal is
 * accepted only while the document is what it changes: else it stays as it is, and is outdated. Of several who accept one, or
 * accept proposals of one revision, exactly one does.
 *
 * id: Of a proposal.
 *
 * author: Who does it: their account, or one of their pages, `NAME~...`; absent: the account.
 *
 * 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: `conflict`: the document has changed since; or the proposal was decided before.
 *
 * 413: There are 10000 documents, or 100000 revisions of it (`too_large`).
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
export const acceptProposal = (id: string, options: { readonly author?: string | undefined } = {}): Call<Proposal> => ({
  method: "POST",
  path: `/api/v1/proposals/${segment(id)}/accept`,
  query: { author: options.author },
  answer: schema.proposal,
});

/**
 * Declines a proposal, with a reason if there is one to say.
 *
 * id: Of a proposal.
 *
 * author: Who does it: their account, or one of their pages, `NAME~...`; absent: the account.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: `conflict`: it was decided before.
 *
 * 413: `too_large`: the reason is too long.
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
export const declineProposal = (
  id: string,
  body?: Body<ProposalDecline>,
  options: { readonly author?: string | undefined } = {},
): Call<Proposal> => ({
  method: "POST",
  path: `/api/v1/proposals/${segment(id)}/decline`,
  query: { author: options.author },
  body,
  answer: schema.proposal,
});
