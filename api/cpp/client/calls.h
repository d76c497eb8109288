// All routes of the server, a function for each: what it sends. Its comment says what Client::send() answers, and by
// status what refuses it; the request filter of the server may also refuse each. Made by api/python/generate/main.py.
// clang-format off
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "api/cpp/client/call.h"

namespace race::client::calls {

/// The server answers. It asks nothing that may take long.
///
/// Answers api/schemas/health.json.
Call get_health();

/// What an operator of the server watches, in the text format 0.0.4 of Prometheus.
///
/// Answers a text.
///
/// Requests by route, clients, cores by status, macro steps, services, the lateness of the cell, logins that failed,
/// lines of the log, and the process itself; deploy/README.md has a table. It asks nobody who may take long, so it may
/// be asked often.
Call get_metrics();

/// Who asks, and whether the server has accounts. Also answered to who is not known.
///
/// Answers api/schemas/me.json.
Call get_me();

/// Changes one's own password. All tokens of the account end, also that of the request.
///
/// Body: api/schemas/password_change.json. Answers api/schemas/empty.json.
///
/// The old password is tried as by a login, and counts for the same limit: who has found a token does not find out the
/// password.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or the new password can be none
/// (`out_of_range`).
///
/// 403: `password`: the old password is another one; `rights`: a process has none.
///
/// 404: Who asks has no account: the server has none (`not_found`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 429: Too many logins or codes have failed, of this address or name (`attempts`); no password and no code was looked
/// at.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot
/// be written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call change_password(const Value& body);

/// A token for a password. It ends after twelve hours, or with a logout or a new password.
///
/// Body: api/schemas/login.json. Answers api/schemas/login_answer.json.
///
/// A name that nobody has is answered as a wrong password is, and as late. Failures are limited, of an address (10 at
/// once, then one in 6 s) and of a name (50 at once, then one in 20 s). An account has 100 tokens; beyond that, its
/// oldest login ends.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 401: There is no account of this name with this password (`login`).
///
/// 413: The account has 100 tokens that are no logins (`too_large`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 429: Too many logins or codes have failed, of this address or name (`attempts`); no password and no code was looked
/// at.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot
/// be written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call log_in(const Value& body);

/// Ends the token of the request. WebSockets that were opened by it end soon after.
///
/// Answers api/schemas/empty.json.
///
/// Without accounts there is none, and nothing is done.
///
/// 404: It has ended meanwhile (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call log_out();

/// A ticket that opens a WebSocket (GET /api/v1/stream), once and within 30 s, for a browser, which cannot send a token
/// with it.
///
/// Answers api/schemas/ticket.json.
///
/// Who opens it is who has asked for the ticket. At most 1000 wait; the oldest go.
Call create_ticket();

/// A code with which a phone gets a token of the account of who asks, once and within 60 s.
///
/// Body: api/schemas/pairing_create.json. Answers api/schemas/pairing_created.json.
///
/// The page shows it as a QR code, with an address of the server. What the token may is the lower of its role and that
/// of the account, also when that changes later. A login has one code: a new one replaces it. At most 64 codes wait,
/// and 8 of an account.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or `role` or `days` is out of its range
/// (`out_of_range`).
///
/// 409: The server has no accounts: who reaches it, on its machine alone, needs no code (`no_accounts`).
///
/// 422: The request does not fit its schema; `name`: that names no display.
///
/// 429: 64 codes wait already, or 8 of the account (`too_many`).
Call create_pairing(const Value& body);

/// A token for a code (POST /api/v1/pairings). It stands at the cell, as an account of the group `local`.
///
/// Body: api/schemas/pair.json. Answers api/schemas/pair_answer.json.
///
/// A code that is none, was used or is too old is answered alike, and so is one whose maker has logged out, has another
/// role or is gone. Attempts count as logins of this address do. The token is listed and revoked as others of the
/// account.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 401: The code brings nothing (`pairing`).
///
/// 409: The server has no accounts: who reaches it, on its machine alone, needs no code (`no_accounts`).
///
/// 413: The account has 100 tokens that are no logins (`too_large`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 429: Too many logins or codes have failed, of this address or name (`attempts`); no password and no code was looked
/// at.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call pair(const Value& body);

/// Where the network reaches this server; nowhere, if it listens on its own machine alone.
///
/// Answers api/schemas/addresses.json.
Call get_addresses();

/// The accounts, by name.
///
/// Answers api/schemas/accounts.json.
Call list_accounts();

/// Makes an account. The first is an admin's, with a password; from then on everybody needs one.
///
/// Body: api/schemas/account_create.json. Answers api/schemas/account.json.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or the role, password or component group can be
/// none (`out_of_range`).
///
/// 409: There is an account of this name (`conflict`).
///
/// 413: There are 200 accounts (`too_large`).
///
/// 422: The request does not fit its schema. `name`: that can be none; `missing`: a process has no group;
/// `not_accepted`: another role has groups, a process has a password, or the first account is no admin's with a
/// password.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot
/// be written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call create_account(const Value& body);

/// Changes role, component groups or password of an account; what is absent stays.
///
/// Body: api/schemas/account_change.json. Answers api/schemas/account.json.
///
/// A new password ends all its tokens. Its WebSockets end soon after if it has another role or other groups now, or
/// their token has ended. A person does not become a process, nor a process a person.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or the role, password or component group can be
/// none (`out_of_range`).
///
/// 404: There is no such account (`not_found`).
///
/// 409: `conflict`: no admin with a password would be left.
///
/// 422: The request does not fit its schema. `missing`: a process would have no group; `not_accepted`: another role
/// would have groups, a process a password, or a person would become a process or a process a person.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot
/// be written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call change_account(std::string_view name, const Value& body);

/// Removes an account with all its tokens. What it has made stays; its WebSockets end soon after.
///
/// Answers api/schemas/account_removed.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: no admin with a password would be left.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call delete_account(std::string_view name);

/// The tokens of an account that have not expired, the oldest first. The secrets are not kept.
///
/// Answers api/schemas/account_tokens.json.
///
/// 404: There is nothing of this name or number (`not_found`).
Call list_tokens(std::string_view name);

/// Makes a token of an account, for a program or a process.
///
/// Body: api/schemas/token_create.json. Answers api/schemas/token_created.json.
///
/// The answer alone has the secret. The token itself has no address; the list of tokens has its label and digest.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or `days` or `role` is out of its range
/// (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 413: The label has more than 100 characters, or the account has 100 tokens that are no logins (`too_large`).
///
/// 422: The request does not fit its schema; `not_accepted`: the label is `login`, the account may do less than `role`,
/// or a process would have a role or be `local`.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call create_token(std::string_view name, const Value& body);

/// Ends a token of an account. WebSockets that were opened by it end soon after.
///
/// Answers api/schemas/token_removed.json.
///
/// 404: There is no such account, or it has no such token (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call revoke_token(std::string_view name, std::string_view digest);

/// The certificate of the authority that has signed for this server, as PEM; a device that trusts it knows the server
/// by it.
///
/// Answers a text.
///
/// 404: There is nothing of this name or number (`not_found`).
Call get_authority();

/// Stops the cell, for everybody who asks: every safe operation of all services is called, all runs are ended, and
/// nothing moves until the reset. This is not a safety function. A body is not needed. A thread of its own serves the
/// same on a port of its own (control.json, `stop_ports`), which reads a header of 1 KiB and nothing else, and answers
/// `{"stopped": true}`.
///
/// Answers api/schemas/control.json.
Call stop_cell();

/// Motions may begin again; none does by that. Runs that the stop has ended are over. Of a cell that is not stopped
/// nothing happens.
///
/// Answers api/schemas/control.json.
Call reset_stop();

/// Whether the cell is stopped, what runs have reserved, and where a stop is served. Who is not known learns no names.
///
/// Answers api/schemas/control.json.
Call get_control();

/// A person at the cell lets somebody take the controls from who has them (control.json, `request`), or not. What moved
/// by them stops. At a server with accounts, an account of the group `local` alone may answer; at one without,
/// everybody on its machine.
///
/// Body: api/schemas/control_answer.json. Answers api/schemas/control.json.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: Nobody asks with that, or no more.
///
/// 422: The body does not fit its schema.
Call answer_control_request(const Value& body);

struct SetCellModeOptions {
  std::optional<std::string> race_control = {};
};
/// Sets the mode of the cell. What moves stops, and runs that moved something, or are watched, are paused. It stays
/// over a restart.
///
/// Body: api/schemas/control_mode.json. Answers api/schemas/control.json.
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 409: `leased`: who asks has not the controls of the cell.
///
/// 422: The body does not fit its schema.
Call set_cell_mode(const Value& body, const SetCellModeOptions& options = {});

struct GetAuditOptions {
  std::optional<std::int64_t> before = {};
  std::optional<std::int64_t> limit = {};
};
/// Who has changed what, the last first. At most 100000 rows are kept; the oldest go.
///
/// Answers api/schemas/audit.json.
///
/// A row for each request and message that changes something and that its sender may send, with the answer, also if
/// that refuses it. What was sent is not in it. A row is there soon after its answer. Of logins with a wrong password,
/// of wrong codes and of stops of a stopped cell there are few; of logins whose password or code was not looked at
/// there are none.
///
/// before: Only rows before this one: `next` of the answer before.
///
/// limit: How many at most.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_audit(const GetAuditOptions& options = {});

/// The rules of the semantics, in their order; every derivation names rules of this list.
///
/// Answers api/schemas/rules.json.
Call get_rules();

struct ListDocumentsOptions {
  std::optional<std::string> after = {};
  std::optional<std::int64_t> limit = {};
};
/// The documents and drafts of the server, by name.
///
/// Answers api/schemas/documents.json.
///
/// after: Only names after this one: `next` of the answer before.
///
/// limit: How many at most.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call list_documents(const ListDocumentsOptions& options = {});

struct GetDocumentOptions {
  std::optional<std::string> if_none_match = {};
};
/// One document or draft as it is edited, with links and oracles, and every violation.
///
/// Answers api/schemas/document_entry.json.
///
/// name: Of a document.
///
/// if_none_match: Tags of revisions that the client has, or `*`. After a restored backup a revision may be another one.
///
/// 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 422: It was stored by an earlier version of the server and is no draft any more; every violation.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_document(std::string_view name, const GetDocumentOptions& options = {});

struct PutDocumentOptions {
  std::optional<bool> draft = {};
  std::optional<std::string> author = {};
  std::optional<std::string> message = {};
  std::optional<std::int64_t> revision = {};
  std::optional<std::string> if_match = {};
  std::optional<std::string> if_none_match = {};
};
/// Stores a document under a name, as the next revision. Refused whole, with every violation, if it breaks a constraint
/// and is no draft.
///
/// Body: api/schemas/document.json. Answers api/schemas/document_entry.json.
///
/// What is stored, and answered, may differ from what was sent (core/SEMANTICS.md section 1): an element without id
/// gets the one that the element at its place had in the last revision, else a new one; of elements with the same id,
/// all but one get new ones; and keys of `layout` that are paths become ids. A draft whose shape is wrong is kept as it
/// was sent. What is the same as the last revision is that revision.
///
/// name: Of a document.
///
/// draft: It may have violations, which the answer lists; any object will do.
///
/// message: Why it was changed.
///
/// revision: The last revision that the author has seen: if there is a later one, the answer is 409.
///
/// if_match: The strong tag of a revision: nothing is changed unless that is the last one.
///
/// if_none_match: There must be no document of this name.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or a parameter is none (`out_of_range`); or the
/// document with its ids would be too deep to be read again (`too_deep`).
///
/// 409: `conflict`: `revision` is not the last one.
///
/// 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that
/// there is none.
///
/// 413: With its links it has too many states, or its text with the ids would be too large to be read again; the author
/// or message is too long; there are 10000 documents or 100000 revisions of it (`too_large`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call put_document(std::string_view name, const Value& body, const PutDocumentOptions& options = {});

struct DeleteDocumentOptions {
  std::optional<std::string> if_match = {};
};
/// Removes a document or draft with all its revisions, also a damaged one. Its runs stay.
///
/// Answers api/schemas/document_removed.json.
///
/// A core that has executed it keeps what it executes. A document that is stored under the same name later goes on
/// after the last revision of this one. For who follows it on the stream, it ends with `not_found`.
///
/// name: Of a document.
///
/// if_match: The strong tag of a revision: nothing is changed unless that is the last one.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: A core has it whose run is not over, or the boot list (`conflict`).
///
/// 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that
/// there is none.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call delete_document(std::string_view name, const DeleteDocumentOptions& options = {});

struct EditDocumentOptions {
  std::optional<std::string> if_match = {};
};
/// Edits a document or draft as it is now, whatever others have done since its author saw it; undo and redo by author.
///
/// Body: api/schemas/edit_request.json. Answers api/schemas/accepted_edit.json.
///
/// Whoever is subscribed to the channel document/{name} of the stream hears of it. An edit may leave violations, which
/// the answer lists. A draft whose shape is wrong cannot be edited.
///
/// name: Of a document.
///
/// if_match: The strong tag of a revision: the edit is made only if that is the last one. Stands for `revision`, if
/// that is absent.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`); the document would be too deep to be read again
/// (`too_deep`); there is no such revision, or If-Match is none (`out_of_range`); neither says a revision (`missing`);
/// the document that is stored is no draft.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: others have changed the same thing since, and the message says who, in which revision; or the shape
/// of the draft is wrong.
///
/// 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that
/// there is none.
///
/// 413: The author or message is too long, there are too many operations, the document would become too large, or it
/// has 100000 revisions (`too_large`).
///
/// 422: The request does not fit its schema; an operation cannot be applied, or a compound edit cannot be made, for the
/// reason that its errors say; there is nothing to undo or redo (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call edit_document(std::string_view name, const Value& body, const EditDocumentOptions& options = {});

struct ListRevisionsOptions {
  std::optional<std::int64_t> before = {};
  std::optional<std::int64_t> limit = {};
};
/// Who changed a document, when and why; the newest revision first.
///
/// Answers api/schemas/revisions.json.
///
/// name: Of a document.
///
/// before: Only revisions before this one.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call list_revisions(std::string_view name, const ListRevisionsOptions& options = {});

struct GetRevisionOptions {
  std::optional<std::string> if_none_match = {};
};
/// A document as it was in a revision; its violations are those that it has today.
///
/// Answers api/schemas/document_entry.json.
///
/// name: Of a document.
///
/// revision: Of the document.
///
/// if_none_match: Tags of revisions that the client has, or `*`. After a restored backup a revision may be another one.
///
/// 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 422: It was stored by an earlier version of the server and is no draft any more; every violation.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_revision(std::string_view name, std::int64_t revision, const GetRevisionOptions& options = {});

struct RestoreDocumentOptions {
  std::optional<std::string> if_match = {};
};
/// Makes the text of an earlier revision the next one. What is the same as the last revision is that revision.
///
/// Body: api/schemas/document_restore.json. Answers api/schemas/document_entry.json.
///
/// name: Of a document.
///
/// if_match: The strong tag of a revision: nothing is changed unless that is the last one.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`), or If-Match is no tag of a
/// revision (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that
/// there is none.
///
/// 413: The author or message is too long, or it has 100000 revisions (`too_large`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call restore_document(std::string_view name, const Value& body, const RestoreDocumentOptions& options = {});

struct BranchDocumentOptions {
  std::optional<std::string> idempotency_key = {};
};
/// Makes a revision the first one of a document of its own. Its elements keep their ids.
///
/// Body: api/schemas/document_branch.json. Answers api/schemas/document_entry.json.
///
/// name: Of a document.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: there is a document of this name.
///
/// 413: The author or message is too long, or there are 10000 documents (`too_large`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call branch_document(std::string_view name, const Value& body, const BranchDocumentOptions& options = {});

/// The breakpoints that a person keeps at a document; none if they have never set any, or there is no such document.
///
/// Answers api/schemas/document_breakpoints.json.
///
/// name: Of a document.
///
/// author: Whose they are: the name of a person.
///
/// 413: `too_large`: the author has more than 100 characters.
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_document_breakpoints(std::string_view name, std::string_view author);

/// Replaces the breakpoints that a person keeps at a document, until it is removed.
///
/// Body: api/schemas/document_breakpoints.json. Answers api/schemas/document_breakpoints.json.
///
/// They change no core: a client gives them to the cores that it lets go (PUT cores/{id}/breakpoints?author=). Of more
/// than 100 people at a document, who has set theirs longest ago loses them.
///
/// name: Of a document.
///
/// author: Whose they are: the name of a person.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 413: `too_large`: there are more than 100, or a text is too long.
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call put_document_breakpoints(std::string_view name, std::string_view author, const Value& body);

/// The document translated to what executes (no links, no oracles), and where each element came from.
///
/// Answers api/schemas/native.json.
///
/// name: Of a document.
///
/// 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 422: It is a draft; every violation.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_document_native(std::string_view name);

/// The document as a bundle, with the interfaces of the services that it needs, as they are here.
///
/// Answers api/schemas/bundle.json.
///
/// What it calls by `svc[...]` is not known. POST bundles installs it elsewhere.
///
/// name: Of a document.
///
/// 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 422: It is a draft; every violation.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_document_bundle(std::string_view name);

struct InstallBundleOptions {
  std::optional<std::string> as = {};
  std::optional<std::string> author = {};
  std::optional<std::string> message = {};
  std::optional<std::string> if_match = {};
  std::optional<std::string> idempotency_key = {};
};
/// Stores the document of a bundle, and says which services it lacks here. Refused whole if anything in it is wrong.
///
/// Body: api/schemas/bundle.json. Answers api/schemas/bundle_installed.json.
///
/// as: The name of the document, if it is not that of the bundle.
///
/// message: Why.
///
/// if_match: The strong tag of a revision: nothing is changed unless that is the last one.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or a parameter is none (`out_of_range`); or the
/// document with its ids would be too deep to be read again (`too_deep`).
///
/// 409: `conflict`: there is a document of this name, and no If-Match.
///
/// 412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that
/// there is none.
///
/// 413: It has more than 100 services; or with its links the document has too many states, or its text with the ids
/// would be too large to be read again; the author or message is too long; there are 10000 documents or 100000
/// revisions of it (`too_large`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call install_bundle(const Value& body, const InstallBundleOptions& options = {});

struct ProposeDocumentOptions {
  std::optional<std::string> author = {};
  std::optional<std::string> idempotency_key = {};
};
/// Proposes a change of a document, or a new one. It changes nothing until somebody who may change documents accepts
/// it.
///
/// Body: api/schemas/proposal_request.json. Answers api/schemas/proposal.json.
///
/// Who may not change documents proposes; who may does not need to. The document is checked as one that is put: it must
/// have no violations, and is kept with ids. At most 100 proposals are open, 20 of an author, with documents of at most
/// 64 MiB, 32 MiB of an author; of those that are decided, the last 200 are kept, with documents of at most 64 MiB. The
/// channel `proposals` of the stream tells of them.
///
/// name: Of a document.
///
/// author: Who does it: their account, or one of their pages, `NAME~...`; absent: the account.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`), or the document with its ids
/// would be too deep to be read again (`too_deep`).
///
/// 409: `conflict`: `revision` is not the last one; or it says none, and there is a document of this name.
///
/// 413: With its links the document has too many states, or its text with the ids would be too large to be read again;
/// the note is too long; too many proposals are open, or too large ones, in all or of this author (`too_large`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call propose_document(std::string_view name, const Value& body, const ProposeDocumentOptions& options = {});

struct ListProposalsOptions {
  std::optional<std::string> document = {};
  std::optional<std::string> status = {};
  std::optional<std::string> after = {};
  std::optional<std::int64_t> limit = {};
};
/// Proposed changes of documents, the oldest first; of those that are decided, the last ones.
///
/// Answers api/schemas/proposals.json.
///
/// document: Only those of this document.
///
/// status: Only those with this status.
///
/// after: Only those after this one: `next` of the answer before.
///
/// limit: How many at most.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call list_proposals(const ListProposalsOptions& options = {});

/// One proposal, with the document that it proposes.
///
/// Answers api/schemas/proposal.json.
///
/// id: Of a proposal.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_proposal(std::string_view id);

struct WithdrawProposalOptions {
  std::optional<std::string> author = {};
};
/// Withdraws an open proposal. For its author, and for who may change documents.
///
/// Answers api/schemas/proposal.json.
///
/// id: Of a proposal.
///
/// author: Who does it: their account, or one of their pages, `NAME~...`; absent: the account.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: it was decided before.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call withdraw_proposal(std::string_view id, const WithdrawProposalOptions& options = {});

struct AcceptProposalOptions {
  std::optional<std::string> author = {};
};
/// Makes a proposal the next revision of its document.
///
/// Answers api/schemas/proposal.json.
///
/// The author of the revision is who accepts it; its origin names who has proposed it, and its message is the note. A
/// proposal is accepted only while the document is what it changes: else it stays as it is, and is outdated. Of several
/// who accept one, or accept proposals of one revision, exactly one does.
///
/// id: Of a proposal.
///
/// author: Who does it: their account, or one of their pages, `NAME~...`; absent: the account.
///
/// 400: An earlier version of the server stored what is no JSON within today's limits (`json`, `too_deep`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: the document has changed since; or the proposal was decided before.
///
/// 413: There are 10000 documents, or 100000 revisions of it (`too_large`).
///
/// 422: It was stored by an earlier version of the server and is no draft any more; every violation.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call accept_proposal(std::string_view id, const AcceptProposalOptions& options = {});

struct DeclineProposalOptions {
  std::optional<std::string> author = {};
};
/// Declines a proposal, with a reason if there is one to say.
///
/// Body: api/schemas/proposal_decline.json. Answers api/schemas/proposal.json.
///
/// id: Of a proposal.
///
/// author: Who does it: their account, or one of their pages, `NAME~...`; absent: the account.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: it was decided before.
///
/// 413: `too_large`: the reason is too long.
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call decline_proposal(std::string_view id, const std::optional<Value>& body = {},
                      const DeclineProposalOptions& options = {});

/// The backups that are whole, by time; also while another one is made.
///
/// Answers api/schemas/backups.json.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call list_backups();

struct CreateBackupOptions {
  std::optional<std::string> idempotency_key = {};
};
/// Copies all that the server keeps, as it is now; runs go on meanwhile. At most 20 are kept.
///
/// Answers api/schemas/backup.json.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// 409: There are 20 already, or the request of this Idempotency-Key is under way (`conflict`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call create_backup(const CreateBackupOptions& options = {});

struct CreateBackupTaskOptions {
  std::optional<std::string> idempotency_key = {};
};
/// As create_backup, but answered before it is done: get_task says what it comes to. The server works on 16 such
/// requests at most (503, `unavailable`).
///
/// Answers api/schemas/task.json.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// 409: There are 20 already, or the request of this Idempotency-Key is under way (`conflict`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call create_backup_task(const CreateBackupTaskOptions& options = {});

/// One backup.
///
/// Answers api/schemas/backup.json.
///
/// 404: There is nothing of this name or number (`not_found`).
Call get_backup(std::string_view name);

/// Removes a backup.
///
/// Answers api/schemas/backup.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call delete_backup(std::string_view name);

/// Makes all that the server keeps what it was then. Cores are removed.
///
/// Answers api/schemas/backup.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: A run is not over (`conflict`).
///
/// 422: A newer version of the program made it (`version`).
///
/// 500: The backup is damaged (`corrupt`); nothing is changed.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call restore_backup(std::string_view name);

/// As restore_backup, but answered before it is done: get_task says what it comes to. The server works on 16 such
/// requests at most (503, `unavailable`).
///
/// Answers api/schemas/task.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: A run is not over (`conflict`).
///
/// 422: A newer version of the program made it (`version`).
///
/// 500: The backup is damaged (`corrupt`); nothing is changed.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call restore_backup_task(std::string_view name);

/// The services of the server with RSM, state, pending calls, violations and data flows.
///
/// Answers api/schemas/services.json.
Call list_services();

struct CallServiceOptions {
  std::optional<std::string> race_control = {};
};
/// Calls one operation of a service, and answers its response.
///
/// Body: api/schemas/service_call.json. Answers api/schemas/service_response.json.
///
/// An operation that `moves` is called by hand: it needs the controls of the cell, and the mode `programming`. What
/// refuses it there is an error of the response, as on the WebSocket of the controls. One that is `safe` ends what a
/// person moves there while they hold a button. An operation that the service does not have is answered `unavailable`.
/// The response is waited for 5 s: after that the call is abandoned, and what it began may go on.
///
/// service: Of a service, as in `svc.KEY` (services.json).
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `leased`: the operation moves, and who asks has not the controls of the cell, or it changes something, and
/// somebody else has them; `stopped`: one that is called while a button is held, which was held when the cell was
/// stopped or got another mode, or a request stopped the service.
///
/// 422: The body does not fit its schema.
///
/// 429: 4 calls of the account wait already (`too_many`); none of them waits for more than 5 s. Without accounts, 16
/// may. What reads, what is `safe`, and all else is counted by itself.
///
/// 503: The service has not responded within 5 s, or 16 calls by requests wait already (`unavailable`, with
/// Retry-After). What reads, what is `safe`, and all else is counted by itself.
Call call_service(std::string_view service, const Value& body, const CallServiceOptions& options = {});

/// The cores, running or not.
///
/// Answers api/schemas/cores.json.
Call list_cores();

struct CreateCoreOptions {
  std::optional<std::string> idempotency_key = {};
};
/// Makes a core of a document and arguments. It waits to be started.
///
/// Body: api/schemas/core_create.json. Answers api/schemas/core.json.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: No such document (`not_found`).
///
/// 409: There are 128 cores already, and no run of them is over, or a backup is being restored (`conflict`).
///
/// 422: The request does not fit its schema, an argument does not fit, or the document has violations.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call create_core(const Value& body, const CreateCoreOptions& options = {});

/// One core.
///
/// Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// 404: There is nothing of this name or number (`not_found`).
Call get_core(std::string_view id);

/// Removes a core; one that runs is stopped first.
///
/// Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: It is being loaded or removed (`conflict`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call delete_core(std::string_view id);

/// Loads another document, its last revision, or other arguments into a core that has not begun. It waits to be
/// started, as before.
///
/// Body: api/schemas/core_load.json. Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: No such core or document.
///
/// 409: Its run has begun, make another core; or it is being loaded or removed, or a backup is being restored
/// (`conflict`).
///
/// 422: An argument does not fit, or the document has violations; nothing is changed.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call load_core(std::string_view id, const Value& body);

struct StartCoreOptions {
  std::optional<std::string> race_control = {};
};
/// Starts a core that waits; the first macro step activates the root. With arguments, these take the place of those
/// that it was created with.
///
/// Body: api/schemas/core_start.json. Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: It was started before; or, as of resumeCore, it may not move.
///
/// 422: An argument does not fit, or the body is none; nothing is changed.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call start_core(std::string_view id, const std::optional<Value>& body = {}, const StartCoreOptions& options = {});

/// Holds a core between macro steps, also before its start. Inputs go on waiting.
///
/// Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: The run is over (`conflict`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call pause_core(std::string_view id);

struct ResumeCoreOptions {
  std::optional<std::string> race_control = {};
};
/// Lets a paused or interrupted core go on. 409 also: `stopped`: the cell is; `leased`: somebody else has the controls
/// of the cell; `conflict`: the run needs who begins it at the controls.
///
/// Body: api/schemas/core_resume.json. Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: The run is over (`conflict`).
///
/// 422: The body does not fit its schema.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call resume_core(std::string_view id, const std::optional<Value>& body = {}, const ResumeCoreOptions& options = {});

/// Aborts a run between macro steps. No exit function runs; the safe operations of the services it called are invoked.
///
/// Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: It is over or was not started.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call stop_core(std::string_view id);

struct StepCoreOptions {
  std::optional<std::string> race_control = {};
};
/// Lets a paused core do one micro step, one macro step, or go on until what a breakpoint could name. It is paused
/// afterwards, and while its step waits for an input; then another step may take its place.
///
/// Body: api/schemas/step_request.json. Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: No such state, port, action or operation.
///
/// 409: It is not paused; or, as of resumeCore, it may not move.
///
/// 422: The request is no step; every violation.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call step_core(std::string_view id, const Value& body, const StepCoreOptions& options = {});

struct ConfirmCoreEditOptions {
  std::optional<std::string> race_control = {};
};
/// An edit that waits for it may reach the run (core.json, `unconfirmed`); only who has the controls of the cell says
/// so.
///
/// Body: api/schemas/core_confirm_edit.json. Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: no edit to this revision waits; `leased`: who asks has not the controls.
///
/// 422: The body does not fit its schema.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
Call confirm_core_edit(std::string_view id, const Value& body, const ConfirmCoreEditOptions& options = {});

struct SetBreakpointsOptions {
  std::optional<std::string> author = {};
};
/// Sets where the core is paused, in place of what the same person has set before. Breakpoints end the step under way,
/// too.
///
/// Body: api/schemas/breakpoints.json. Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// author: Who sets them: those of others stay. Without it they take the place of all.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: No such state, port, action or operation.
///
/// 409: The run is over (`conflict`).
///
/// 413: `too_large`: there are more than 100, with those of others; a condition has more than 500 characters, or the
/// author more than 100.
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call set_breakpoints(std::string_view id, const Value& body, const SetBreakpointsOptions& options = {});

/// Whether the core follows the edits of its document. A running core gets each revision without violations between
/// macro steps, as soon as everything active has a place in it; until then `waiting_edit` says what it waits for.
///
/// Body: api/schemas/core_live.json. Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: The run is over (`conflict`).
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call set_core_live(std::string_view id, const Value& body);

struct ForceCoreOptions {
  std::optional<std::string> race_control = {};
};
/// Sets a parameter, result or variable of a running core, or takes a port of an active state, in a macro step of its
/// own. A paused core stays paused after it. As the run may move by that, who has the controls of the cell does it, if
/// anybody has them.
///
/// Body: api/schemas/force.json. Answers api/schemas/core.json.
///
/// id: Of a core.
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: No such core, state, value or port.
///
/// 409: It is not running, is paused in a macro step, or the state of the port is not active. `leased`: somebody else
/// has the controls of the cell; `conflict`: nobody has, and the run needs who began it, or has moved something at a
/// server with accounts.
///
/// 413: `too_large`: the value is beyond the budget of the run.
///
/// 422: Every violation of the request, or of the document that it brings or names.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call force_core(std::string_view id, const Value& body, const ForceCoreOptions& options = {});

/// The native model that this core executes.
///
/// Answers api/schemas/native.json.
///
/// id: Of a core.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_core_native(std::string_view id);

/// What is active, and the values, after the last step.
///
/// Answers api/schemas/core_state.json.
///
/// id: Of a core.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_core_state(std::string_view id);

struct GetDerivationsOptions {
  std::optional<std::int64_t> from = {};
  std::optional<std::int64_t> to = {};
};
/// The derivations of macro steps, recomputed from the journal; at most 100 steps of an answer.
///
/// Answers api/schemas/derivations.json.
///
/// id: Of a core.
///
/// from: First macro step; else the last one.
///
/// to: Last macro step; else `from`.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_derivations(std::string_view id, const GetDerivationsOptions& options = {});

/// The run so far as a script; with the model of `native` (as a document), `race derive` gives this run's derivations.
///
/// Answers api/schemas/script.json.
///
/// id: Of a core.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
/// /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_core_script(std::string_view id);

/// Header and inputs of the run, in order of delivery; the run is a function of these.
///
/// Answers api/schemas/journal.json.
///
/// id: Of a core.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
/// /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_core_journal(std::string_view id);

struct GetWhyOptions {
  std::optional<std::string> port = {};
  std::optional<std::string> state = {};
  std::optional<std::int64_t> action = {};
  std::optional<std::string> parameter = {};
  std::optional<std::int64_t> step = {};
  std::optional<std::int64_t> micro = {};
};
/// Why a port fired or does not fire, an action was executed or is not, or a parameter has its value.
///
/// Answers api/schemas/why.json.
///
/// id: Of a core.
///
/// port: A port, as Root/A.success; or `state` with one of `action` and `parameter`.
///
/// state: The state of the action or parameter, as Root/A.
///
/// action: Its number within the state, from 0.
///
/// parameter: Its name.
///
/// step: With `micro`: as things were in this macro step; else as they are now.
///
/// micro: Before this micro step of it, and when the turn of what is asked about comes in it; those that the derivation
/// of the step lists.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: No such core, port, action or parameter.
///
/// 409: `conflict`: more than one thing is asked about.
///
/// 422: `missing`: what is asked about, or one of `step` and `micro`
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_why(std::string_view id, const GetWhyOptions& options = {});

struct GetPastOptions {
  std::optional<std::int64_t> micro = {};
};
/// The run as it was at an earlier micro step, recomputed from the journal. Nothing of it is done again; robots and
/// services stay where they are.
///
/// Answers api/schemas/past.json.
///
/// id: Of a core.
///
/// step: A macro step that has begun.
///
/// micro: After this many micro steps of it; absent, or more than it has: at its end.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 422: `missing`: the step
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read
/// or written (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_past(std::string_view id, std::int64_t step, const GetPastOptions& options = {});

struct ListQueueOptions {
  std::optional<std::int64_t> after = {};
  std::optional<std::int64_t> limit = {};
};
/// The runs that wait their turn, and those before them, in order; at most 100 of an answer.
///
/// Answers api/schemas/queue.json.
///
/// after: Only those with a larger id.
///
/// 400: A parameter is out of its range (`out_of_range`).
Call list_queue(const ListQueueOptions& options = {});

struct QueueRunOptions {
  std::optional<std::string> idempotency_key = {};
  std::optional<std::string> race_control = {};
};
/// Queues a run. It begins when all before it are over; at once, if there are none.
///
/// Body: api/schemas/queued_run_create.json. Answers api/schemas/queued_run.json.
///
/// The document and the arguments are checked now, and this revision is what is executed. It begins as its maker would
/// begin it then (POST cores, then POST start): they must still be who they were, with the same token, and have the
/// controls of the cell if they had them now (Race-Control). If that is not so, or it may not begin for another reason,
/// it is refused, and the queue pauses. It also pauses after a run that was aborted, after a fault unless `on_fault` is
/// go_on, and instead of beginning a run while the cell is stopped; the reset of the stop begins nothing. A run that is
/// paused or interrupted is not over. The queue is empty after a restart of the server, and after a backup is restored
/// all that waits is cancelled.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or `on_fault` is none of its values
/// (`out_of_range`).
///
/// 404: No such document (`not_found`).
///
/// 409: 100 runs wait already, or a backup was restored meanwhile (`conflict`); or who sends it has the controls no
/// more (`leased`).
///
/// 413: `too_large`: the arguments or the name.
///
/// 422: The request does not fit its schema, an argument does not fit, or the document has violations.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call queue_run(const Value& body, const QueueRunOptions& options = {});

/// The queue goes on after a pause. The next run begins as whoever queued it.
///
/// Answers api/schemas/queue.json.
///
/// 409: The cell is stopped (`stopped`): reset it first.
Call resume_queue();

/// One queued run.
///
/// Answers api/schemas/queued_run.json.
///
/// 404: There is nothing of this name or number (`not_found`).
Call get_queued_run(std::string_view id);

/// Cancels a run that waits. One that runs is stopped at its core.
///
/// Answers api/schemas/queued_run.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: It does not wait any more (`conflict`).
Call cancel_queued_run(std::string_view id);

struct ListRunsOptions {
  std::optional<std::string> document = {};
  std::optional<std::int64_t> before = {};
  std::optional<std::int64_t> limit = {};
};
/// The stored runs, the newest first; at most 100 of an answer.
///
/// Answers api/schemas/runs.json.
///
/// document: Only those of this document.
///
/// before: Only those with a smaller number.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call list_runs(const ListRunsOptions& options = {});

struct ImportRunOptions {
  std::optional<std::string> idempotency_key = {};
};
/// Stores the file of a run, of this server or another one, under a new number.
///
/// Body: api/schemas/run_file.json. Answers api/schemas/run.json.
///
/// A file has at most 16 MiB and 642 levels, where other bodies have 4 MiB and 64. It is checked whole: its chain is
/// computed anew, and the run is done again, with at most 4 million micro steps, in at most 20 seconds and within the
/// budgets of a new run. Its document is not stored. Nothing of it is executed.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 409: `conflict`: a run does not take an entry of its journal.
///
/// 413: `too_large`: the file, its samples, or the work or time that its run takes.
///
/// 422: Every violation of the format; `version`; or `corrupt`: the record or the chain is not that of the journal.
///
/// 503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot
/// be read (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call import_run(const Value& body, const ImportRunOptions& options = {});

struct ImportRunTaskOptions {
  std::optional<std::string> idempotency_key = {};
};
/// As import_run, but answered before it is done: get_task says what it comes to. The server works on 16 such requests
/// at most (503, `unavailable`).
///
/// Body: api/schemas/run_file.json. Answers api/schemas/task.json.
///
/// idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is
/// answered as the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer
/// was lost. Refused requests may be sent again. Another request with the key is refused with 422, one that comes while
/// the first is under way with 409 (`conflict`). The last 1000 answers are kept, while the server runs.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 409: `conflict`: a run does not take an entry of its journal.
///
/// 413: `too_large`: the file, its samples, or the work or time that its run takes.
///
/// 422: Every violation of the format; `version`; or `corrupt`: the record or the chain is not that of the journal.
///
/// 503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot
/// be read (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call import_run_task(const Value& body, const ImportRunTaskOptions& options = {});

/// One stored run.
///
/// Answers api/schemas/run.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run(std::string_view run);

/// Removes a run from the store with its journal, also one that is damaged.
///
/// Answers api/schemas/run_removed.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: a core has this run; delete the core first.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call delete_run(std::string_view run);

/// The model that was executed.
///
/// Answers api/schemas/native.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 422: `version`: an earlier version of the server executed it, by other semantics.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_native(std::string_view run);

struct GetRunDerivationsOptions {
  std::optional<std::int64_t> from = {};
  std::optional<std::int64_t> to = {};
};
/// The derivations of macro steps, recomputed from the journal; at most 100 steps of an answer.
///
/// Answers api/schemas/derivations.json.
///
/// from: First macro step; else the last one.
///
/// to: Last macro step; else `from`.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: a run does not take an entry of its journal.
///
/// 413: `too_large`: the replay takes longer than 20 seconds.
///
/// 422: `version`: an earlier version of the server executed it, by other semantics.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot
/// be read (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_derivations(std::string_view run, const GetRunDerivationsOptions& options = {});

struct GetRunPastOptions {
  std::optional<std::int64_t> micro = {};
};
/// The stored run as it was at a micro step, recomputed from the journal. Nothing of it is done again; robots and
/// services stay where they are.
///
/// Answers api/schemas/past.json.
///
/// step: A macro step of it.
///
/// micro: After this many micro steps of it; absent, or more than it has: at its end.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: a run does not take an entry of its journal.
///
/// 413: `too_large`: the replay takes longer than 20 seconds.
///
/// 422: `version`: an earlier version of the server executed it, by other semantics.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot
/// be read (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_past(std::string_view run, std::int64_t step, const GetRunPastOptions& options = {});

struct GetRunWhyOptions {
  std::optional<std::string> port = {};
  std::optional<std::string> state = {};
  std::optional<std::int64_t> action = {};
  std::optional<std::string> parameter = {};
  std::optional<std::int64_t> step = {};
  std::optional<std::int64_t> micro = {};
};
/// Why a port of the stored run fired or an action was executed, or not, or what gave a parameter its value, recomputed
/// from the journal.
///
/// Answers api/schemas/why.json.
///
/// port: A port, as Root/A.success; or `state` with one of `action` and `parameter`.
///
/// state: The state of the action or parameter, as Root/A.
///
/// action: Its number within the state, from 0.
///
/// parameter: Its name.
///
/// step: With `micro`: as things were in this macro step; else as they are at the end of what is stored.
///
/// micro: Before this micro step of it, and when the turn of what is asked about comes in it; those that the derivation
/// of the step lists.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: No such run, port, action or parameter.
///
/// 409: `conflict`: a run does not take an entry of its journal.
///
/// 413: `too_large`: the replay takes longer than 20 seconds.
///
/// 422: `missing`: what is asked about, or one of `step` and `micro`; or `version`.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot
/// be read (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_why(std::string_view run, const GetRunWhyOptions& options = {});

/// Header and inputs of the run, in order of delivery; the run is a function of these.
///
/// Answers api/schemas/journal.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
/// /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.
///
/// 422: `version`: an earlier version of the server executed it, by other semantics.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_journal(std::string_view run);

/// The run as a script; with the model of `native` (as a document), `race derive` gives this run's derivations.
///
/// Answers api/schemas/script.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
/// /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.
///
/// 422: `version`: an earlier version of the server executed it, by other semantics.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_script(std::string_view run);

/// Where everything in the cell was while the run was running. Empty without a world.
///
/// Answers api/schemas/samples.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_samples(std::string_view run);

/// Which pictures of cameras are kept of the time in which the run was running.
///
/// Answers api/schemas/run_pictures.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_pictures(std::string_view run);

/// One of these pictures.
///
/// Answers api/schemas/run_picture.json.
///
/// number: Of the list.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_picture(std::string_view run, std::int64_t number);

struct GetRunTimingOptions {
  std::optional<std::int64_t> from = {};
  std::optional<std::int64_t> to = {};
};
/// When macro steps of the run began, when the inputs came that they deliver, and which states services had meanwhile;
/// at most 1000 steps of an answer.
///
/// Answers api/schemas/timing.json.
///
/// from: First macro step; else 999 before `to`.
///
/// to: Last macro step; else the last one of the run.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_timing(std::string_view run, const GetRunTimingOptions& options = {});

/// All of a run in one file, which any server opens.
///
/// Answers api/schemas/run_file.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
/// /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.
///
/// 422: `version`: an earlier version of the server executed it, by other semantics.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call export_run(std::string_view run);

/// A test of the run as a file for `race test`: its inputs as what mocks answer, and what came of them as what is
/// expected.
///
/// Answers api/schemas/task_test.json.
///
/// 400: `out_of_range`: the run took longer than a test may, a day. `too_deep`: its data is deeper than that of a test
/// may be.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: a run does not take an entry of its journal.
///
/// 413: `too_large`: the test would have more than 4 MiB (4194304 bytes), the journal has more than 16 MiB, or the
/// replay takes longer than 20 seconds.
///
/// 422: `not_accepted`: the run is not over, or somebody has edited, forced or aborted it; or `version`.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot
/// be read (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_run_test(std::string_view run);

struct CompareRunOptions {
  std::optional<std::int64_t> from = {};
};
/// The first macro step of which the derivations, calls or states of two runs differ, and the first derivation in it
/// that does; at most 2000 steps of an answer.
///
/// Answers api/schemas/run_comparison.json.
///
/// with: The other run.
///
/// from: The macro step to begin with; else the first one.
///
/// 400: A parameter is out of its range (`out_of_range`).
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: `conflict`: a run does not take an entry of its journal.
///
/// 413: `too_large`: the replay takes longer than 20 seconds.
///
/// 422: `missing`: with which run; or `version`.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot
/// be read (`io`).
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call compare_run(std::string_view run, std::string_view with, const CompareRunOptions& options = {});

/// How far the work of a request is that was answered 202, before that was done, and what it comes to.
///
/// Answers api/schemas/task.json.
///
/// For who has sent the request, and admins. The last 100 are kept, while the server runs.
///
/// 404: There is nothing of this name or number (`not_found`).
Call get_task(std::string_view id);

/// Tells the work to stop. It may be done all the same.
///
/// Answers api/schemas/task.json.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 409: It is over, or cannot be told to stop, as a backup and its restore (`conflict`).
Call cancel_task(std::string_view id);

/// What the server starts when it begins.
///
/// Answers api/schemas/boot.json.
///
/// 500: What is stored is damaged (`corrupt`); the error names the part.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call get_boot();

/// Replaces the list of what the server starts when it begins.
///
/// Body: api/schemas/boot.json. Answers api/schemas/boot.json.
///
/// When the server begins, a core of each document is created and started, in order, unless the document has a run that
/// is not over: one that was interrupted waits for a person. What cannot be started is logged, and the others are
/// started.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
///
/// 404: No such document; every one.
///
/// 413: `too_large`: there are more than 64 entries.
///
/// 422: Every violation; `duplicate`: a document stands twice.
///
/// 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`):
/// ask again.
///
/// 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then
/// the run is interrupted. Ask again when it works.
Call put_boot(const Value& body);

/// What the cell looks like; its motion is on the channel cell/pose.
///
/// Answers api/schemas/scene.json.
///
/// 404: There is no world here: the server has no cell (`not_found`).
///
/// 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has
/// not begun is dropped; one that it has begun may be completed. Or two commands wait for it already.
Call get_cell();

/// What the hands at the cell hold, and which parts were taken away.
///
/// Answers api/schemas/person.json.
///
/// 404: There is no world here: the server has no cell (`not_found`).
///
/// 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has
/// not begun is dropped; one that it has begun may be completed. Or two commands wait for it already.
Call get_person();

/// A person grabs, drags, releases or pushes a link of the robot or a part, by forces alone; or places a part or takes
/// it away. A hand that nobody drags, and whose target rests, lets go after `keep` seconds. Errors name the field.
///
/// Body: api/schemas/person_command.json. Answers api/schemas/person.json.
///
/// 400: The body is no JSON or out of its limits (`json`, `too_deep`), or a number is out of its range (`out_of_range`,
/// with the limits).
///
/// 404: No such link or part, or no cell.
///
/// 409: The part is taken away, would be inside another body, or the hand holds nothing.
///
/// 422: The command does not fit its schema, or the body cannot be moved.
///
/// 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has
/// not begun is dropped; one that it has begun may be completed. Or two commands wait for it already.
Call command_person(const Value& body);

struct ResetCellOptions {
  std::optional<std::string> race_control = {};
};
/// The cell as it was at the start: parts and robot are where the scene says, at rest, and all hands let go; what waits
/// for an answer of the robot or the gripper is answered `unavailable`. The values of `database.json` become the only
/// ones of the database, unless the body keeps them. Refused while a run has begun and is not over, while the cell is
/// stopped, and while somebody else has its controls.
///
/// Body: api/schemas/cell_reset.json. Answers api/schemas/person.json.
///
/// race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of
/// the cell. 409 (`leased`): they have them no more.
///
/// 404: There is no world here: the server has no cell (`not_found`).
///
/// 409: A run is not over, which the message names; or the cell or the database is a process of its own, or the cell is
/// being reset already (`conflict`). Also `stopped`, and `leased`: somebody else has the controls.
///
/// 422: The body does not fit its schema.
///
/// 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has
/// not begun is dropped; one that it has begun may be completed. Or two commands wait for it already.
Call reset_cell(const std::optional<Value>& body = {}, const ResetCellOptions& options = {});

/// A URDF file that the scene names.
///
/// Answers a text.
///
/// file: Name of a file, as scene.json has it.
///
/// 404: There is nothing of this name or number (`not_found`).
///
/// 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has
/// not begun is dropped; one that it has begun may be completed. Or two commands wait for it already.
Call get_cell_file(std::string_view file);

}  // namespace race::client::calls
