#include "server/handlers/document_requests.h"

#include "server/accounts/gate.h"
#include "server/handlers/preconditions.h"
#include "server/handlers/query.h"
#include "server/http/field_list.h"
#include "server/http/refusal.h"
#include "server/wire/calendar.h"
#include "server/wire/errors.h"

namespace race::server {
namespace {

Value origin_json(const Origin& origin) {
  Dict json{{"kind", name(origin.kind)}};
  if (!origin.document.empty()) json.set("document", origin.document);
  if (origin.kind == Origin::Kind::proposal) {
    json.set("author", origin.author);
    json.set("proposal", std::to_string(origin.revision));
  } else if (origin.revision > 0) {
    json.set("revision", origin.revision);
  }
  return json;
}

Dict with_change(Dict json, const Revision& revision) {
  json.set("revision", revision.number);
  json.set("author", revision.change.author);
  json.set("time", revision.change.time_ms);
  json.set("message", revision.change.message);
  json.set("origin", origin_json(revision.origin));
  return json;
}

}  // namespace

Expected<std::string> author_of(const Request& request) {
  return author_for(request.identity, query_text(request, "author"));
}

Expected<Change> change_of(const Request& request) {
  ASSIGN_OR_RETURN(std::string author, author_of(request));
  return Change{std::move(author), query_text(request, "message"), now_ms()};
}

Change read_change(Fields& fields, const Request& request, std::vector<Error>& errors) {
  const auto author = author_for(request.identity, fields.text("author").value_or(""));
  const auto message = fields.text("message");
  fields.close();
  if (errors.empty() && !author) errors.push_back(author.error());
  return {author.value_or(""), message.value_or(""), now_ms()};
}

std::optional<std::int64_t> read_revision_number(Fields& fields, Fields::Need need) {
  const Value* revision = fields.find("revision", need);
  if (!revision) return std::nullopt;
  if (revision->is_integer() && revision->as_integer() >= 1) return revision->as_integer();
  fields.violation(ErrorCode::type, "`revision` must be a number from 1", "revision");
  return std::nullopt;
}

Value revision_json(const Revision& revision) {
  Dict json = with_change({}, revision);
  json.set("errors", revision.errors);
  return json;
}

Value entry_json(const DocumentEntry& entry) {
  Dict json = with_change({{"name", entry.revision.document}}, entry.revision);
  set_errors(json, entry.errors);
  json.set("document", entry.document);
  return json;
}

Handled answer_entry(const Checked<DocumentEntry>& entry) {
  if (!entry) return tl::unexpected(entry.error());
  const Revision& revision = entry->revision;
  Reply reply =
      entry->is_new ? created(entry_json(*entry), "/api/v1/documents/" + revision.document) : ok(entry_json(*entry));
  add_tag(reply, revision.number);
  return reply;
}

Handled answer_unless_known(const Request& request, const Checked<DocumentEntry>& entry) {
  if (!entry || !if_none_match_lists(request, tag_of(entry->revision.number))) return answer_entry(entry);
  Reply unchanged;
  unchanged.status = 304;
  add_tag(unchanged, entry->revision.number);
  return unchanged;
}

Handled answer_changed(const Checked<DocumentEntry>& entry, bool has_precondition) {
  if (!entry && has_precondition && entry.error().front().code == ErrorCode::conflict)
    return refusal(412, entry.error());
  return answer_entry(entry);
}

}  // namespace race::server
