// What the routes of documents share: the fields of their requests and of their answers.
#pragma once

#include <cstdint>
#include <optional>

#include "core/value/fields.h"
#include "server/handlers/handlers.h"
#include "server/store/documents.h"

namespace race::server {

/// Who changes a document now, and why, by the query (`author`, `message`). Error `rights`: it is not who says so.
Expected<Change> change_of(const Request& request);
/// The same, by the last fields of a body, which is closed; the error is one of `errors`, if there is no other.
Change read_change(Fields& fields, const Request& request, std::vector<Error>& errors);
/// Who it is, by the query (`author`) and the account.
Expected<std::string> author_of(const Request& request);

/// The field `revision`, a number from 1; a violation otherwise.
std::optional<std::int64_t> read_revision_number(Fields& fields, Fields::Need need);

/// schemas/revisions.json, `document_revision`.
Value revision_json(const Revision& revision);
/// schemas/document_entry.json.
Value entry_json(const DocumentEntry& entry);
/// The entry with its tag, 201 if it is new, or its errors.
Handled answer_entry(const Checked<DocumentEntry>& entry);
/// The same, or 304 if If-None-Match lists its tag.
Handled answer_unless_known(const Request& request, const Checked<DocumentEntry>& entry);
/// The same after a change; 412 for a `conflict` if the request had a precondition.
Handled answer_changed(const Checked<DocumentEntry>& entry, bool has_precondition);

}  // namespace race::server
