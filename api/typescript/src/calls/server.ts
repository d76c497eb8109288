// Routes of api/openapi.yaml: server. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Body, type Call } from "../call.js";
import type { Addresses, Audit, Boot, Bundle, BundleInstalled, Empty, Health, Login, LoginAnswer, PairingCreate, PairingCreated, Rules, Task, Ticket } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * The server answers. It asks nothing that may take long.
 */
export const getHealth = (): Call<Health> => ({ method: "GET", path: "/api/v1/health", answer: schema.health });

/**
 * What an operator of the server watches, in the text format 0.0.4 of Prometheus.
 *
 * Requests by route, clients, cores by status, macro steps, services, the lateness of the cell, logins that failed, lines of the
 * log, and the process itself; deploy/README.md has a table. It asks nobody who may take long, so it may be asked often.
 */
export const getMetrics = (): Call<string> => ({ method: "GET", path: "/metrics", answer: "text" });

/**
 * A token for a password. It ends after twelve hours, or with a logout or a new password.
 *
 * A name that nobody has is answered as a wrong password is, and as late. Failures are limited, of an address (10 at once, then
 * one in 6 s) and of a name (50 at once, then one in 20 s). An account has 100 tokens; beyond that, its oldest login ends.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 401: There is no account of this name with this password (`login`).
 *
 * 413: The account has 100 tokens that are no logins (`too_large`).
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 429: Too many logins or codes have failed, of this address or name (`attempts`); no password and no code was looked at.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot be written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const logIn = (body: Body<Login>): Call<LoginAnswer> => ({
  method: "POST",
  path: "/api/v1/login",
  body,
  answer: schema.loginAnswer,
});

/**
 * Ends the token of the request. WebSockets that were opened by it end soon after.
 *
 * Without accounts there is none, and nothing is done.
 *
 * 404: It has ended meanwhile (`not_found`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const logOut = (): Call<Empty> => ({ method: "POST", path: "/api/v1/logout", answer: schema.empty });

/**
 * A ticket that opens a WebSocket (GET /api/v1/stream), once and within 30 s, for a browser, which cannot send a token with it.
 *
 * Who opens it is who has asked for the ticket. At most 1000 wait; the oldest go.
 */
export const createTicket = (): Call<Ticket> => ({ method: "POST", path: "/api/v1/tickets", answer: schema.ticket });

/**
 * A code with which a phone gets a token of the account of who asks, once and within 60 s.
 *
 * The page shows it as a QR code, with an address of the server. What the token may is the lower of its role and that of the
 * account, also when that changes later. A login has one code: a new one replaces it. At most 64 codes wait, and 8 of an account.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or `role` or `days` is out of its range (`out_of_range`).
 *
 * 409: The server has no accounts: who reaches it, on its machine alone, needs no code (`no_accounts`).
 *
 * 422: The request does not fit its schema; `name`: that names no display.
 *
 * 429: 64 codes wait already, or 8 of the account (`too_many`).
 */
export const createPairing = (body: Body<PairingCreate>): Call<PairingCreated> => ({
  method: "POST",
  path: "/api/v1/pairings",
  body,
  answer: schema.pairingCreated,
});

/**
 * Where the network reaches this server; nowhere, if it listens on its own machine alone.
 */
export const getAddresses = (): Call<Addresses> => ({ method: "GET", path: "/api/v1/addresses", answer: schema.addresses });

/**
 * The certificate of the authority that has signed for this server, as PEM; a device that trusts it knows the server by it.
 *
 * 404: There is nothing of this name or number (`not_found`).
 */
export const getAuthority = (): Call<string> => ({ method: "GET", path: "/api/v1/authority", answer: "text" });

/**
 * Who has changed what, the last first. At most 100000 rows are kept; the oldest go.
 *
 * A row for each request and message that changes something and that its sender may send, with the answer, also if that refuses
 * it. What was sent is not in it. A row is there soon after its answer. Of logins with a wrong password, of wrong codes and of
 * stops of a stopped cell there are few; of logins whose password or code was not looked at there are none.
 *
 * before: Only rows before this one: `next` of the answer before.
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
export const getAudit = (
  options: { readonly before?: number | undefined; readonly limit?: number | undefined } = {},
): Call<Audit> => ({
  method: "GET",
  path: "/api/v1/audit",
  query: { before: options.before, limit: options.limit },
  answer: schema.audit,
});

/**
 * The rules of the semantics, in their order; every derivation names rules of this list.
 */
export const getRules = (): Call<Rules> => ({ method: "GET", path: "/api/v1/rules", answer: schema.rules });

/**
 * Stores the document of a bundle, and says which services it lacks here. Refused whole if anything in it is wrong.
 *
 * as: The name of the document, if it is not that of the bundle.
 *
 * message: Why.
 *
 * ifMatch: The strong tag of a revision: nothing is changed unless that is the last one.
 *
 * idempotencyKey: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
 * the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
 * requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
 * 409 (`conflict`). The last 1000 answers are kept, while the server runs.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or a parameter is none (`out_of_range`); or the document
 * with its ids would be too deep to be read again (`too_deep`).
 *
 * 409: `conflict`: there is a document of this name, and no If-Match.
 *
 * 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that there is
 * none.
 *
 * 413: It has more than 100 services; or with its links the document has too many states, or its text with the ids would be too
 * large to be read again; the author or message is too long; there are 10000 documents or 100000 revisions of it (`too_large`).
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
export const installBundle = (
  body: Body<Bundle>,
  options: { readonly as?: string | undefined; readonly author?: string | undefined; readonly message?: string | undefined; readonly ifMatch?: string | undefined; readonly idempotencyKey?: string | undefined } = {},
): Call<BundleInstalled> => ({
  method: "POST",
  path: "/api/v1/bundles",
  query: { as: options.as, author: options.author, message: options.message },
  headers: { "If-Match": options.ifMatch, "Idempotency-Key": options.idempotencyKey },
  body,
  answer: schema.bundleInstalled,
});

/**
 * How far the work of a request is that was answered 202, before that was done, and what it comes to.
 *
 * For who has sent the request, and admins. The last 100 are kept, while the server runs.
 *
 * 404: There is nothing of this name or number (`not_found`).
 */
export const getTask = (id: string): Call<Task> => ({ method: "GET", path: `/api/v1/tasks/${segment(id)}`, answer: schema.task });

/**
 * Tells the work to stop. It may be done all the same.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: It is over, or cannot be told to stop, as a backup and its restore (`conflict`).
 */
export const cancelTask = (id: string): Call<Task> => ({
  method: "DELETE",
  path: `/api/v1/tasks/${segment(id)}`,
  answer: schema.task,
});

/**
 * What the server starts when it begins.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getBoot = (): Call<Boot> => ({ method: "GET", path: "/api/v1/boot", answer: schema.boot });

/**
 * Replaces the list of what the server starts when it begins.
 *
 * When the server begins, a core of each document is created and started, in order, unless the document has a run that is not
 * over: one that was interrupted waits for a person. What cannot be started is logged, and the others are started.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: No such document; every one.
 *
 * 413: `too_large`: there are more than 64 entries.
 *
 * 422: Every violation; `duplicate`: a document stands twice.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const putBoot = (body: Body<Boot>): Call<Boot> => ({ method: "PUT", path: "/api/v1/boot", body, answer: schema.boot });
