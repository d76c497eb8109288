#include "server/handlers/document_requests.h"

#include <charconv>

#include "server/wire/calendar.h"
#include "server/wire/errors.h"

namespace race::server {
namespace {

Value origin_json(const Origin& origin) {
  Dict json{{"kind", name(origin.kind)}};
  if (!origin.document.empty()) json.set("document", origin.document);
  if (origin.revision > 0) json.set("revision", origin.revision);
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

std::string query_text(const Request& request, std::string_view name) {
  const auto found = request.query.find(name);
  return found == request.query.end() ? std::string() : found->second;
}

}  // namespace

Change change_of(const Request& request) {
  return {query_text(request, "author"), query_text(request, "message"), now_ms()};
}

Change read_change(Fields& fields) {
  const auto author = fields.text("author"), message = fields.text("message");
  return {author.value_or(""), message.value_or(""), now_ms()};
}

Expected<std::optional<std::int64_t>> number_of(const Request& request, std::string_view name) {
  const auto found = request.query.find(name);
  if (found == request.query.end()) return std::nullopt;
  const std::string& text = found->second;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1)
    return unexpected(ErrorCode::out_of_range, "must be a number from 1", std::string(name));
  return number;
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
  json.set("errors", *errors_json(entry.errors).find("errors"));
  json.set("document", entry.document);
  return json;
}

Handled answer_entry(const Checked<DocumentEntry>& entry, int status) {
  if (!entry) return tl::unexpected(entry.error());
  Reply reply = ok(entry_json(*entry));
  reply.status = status;
  return reply;
}

}  // namespace race::server
