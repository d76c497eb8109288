// Tools of documents: tasks in RCM, with their revisions.
#include <algorithm>

#include "core/value/json.h"
#include "server/mcp/tool.h"

namespace race::server::mcp {
namespace {

// A revision that no document has: 100000 are the most.
constexpr int kNoRevision = 2'147'483'647;
constexpr std::size_t kPageBytes = std::size_t{128} * 1024;

// Where a text can be cut that was to be cut at `end`: before a character of UTF-8.
std::size_t cut(const std::string& text, std::size_t end) {
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return std::min(end, text.size());
}

// A part of the document's text from `offset` on [bytes], and where the next one begins.
Outcome page_of(const Value& entry, std::int64_t offset) {
  const Value* document = entry.find("document");
  const std::string text = document ? to_json(*document) : std::string();
  const std::size_t begin = cut(text, std::min(static_cast<std::size_t>(offset), text.size()));
  const std::size_t end = cut(text, begin + kPageBytes);
  Dict page{{"text", text.substr(begin, end - begin)},
            {"offset", static_cast<std::int64_t>(begin)},
            {"length", static_cast<std::int64_t>(text.size())}};
  for (const char* key : {"name", "revision"})
    if (const Value* value = entry.find(key)) page.set(key, *value);
  if (end < text.size()) page.set("next", static_cast<std::int64_t>(end));
  return page;
}

}  // namespace

tl::expected<std::string, Problem> author_of(const Context& context) {
  const auto me = context.api.get(Target{"me"});
  if (!me) return tl::unexpected(me.error());
  if (context.cancelled) return tl::unexpected(make_problem({ErrorCode::unavailable, "the request was cancelled"}));
  const Value* name = me->find("name");
  return name && name->is_string() ? name->as_string() + "~mcp" : std::string("mcp");
}

Outcome without(Outcome answer, std::string_view field) {
  if (answer && answer->is_dict()) answer->mutable_dict().erase(field);
  return answer;
}

Outcome list_documents(const Context& context, const Dict& arguments) {
  return context.api.get(
      Target{"documents"}.with("after", arguments.find("after")).with("limit", arguments.find("limit")));
}

Outcome read_document(const Context& context, const Dict& arguments) {
  const std::string& name = text_of(arguments, "name");
  const Value* revision = arguments.find("revision");
  auto entry = context.api.get(revision ? Target{"documents", name, "revisions", to_json(*revision)}
                                        : Target{"documents", name});
  const Value* offset = arguments.find("offset");
  if (!entry || !offset) return entry;
  return page_of(*entry, offset->as_integer());
}

// The server checks what is proposed before it looks at the revision that it would change: this is one that no document
// has, so that nothing is kept.
Outcome check_document(const Context& context, const Dict& arguments) {
  const Value* name = arguments.find("name");
  const Dict body{{"document", *arguments.find("document")}, {"revision", kNoRevision}};
  const auto kept = context.api.post(Target{"documents", name ? name->as_string() : "check", "proposals"}, body);
  if (kept) return tl::unexpected(make_problem({ErrorCode::conflict, "the server has kept a proposal"}));
  if (kept.error().status == 409) return Dict{{"valid", true}, {"errors", List()}};
  const int status = kept.error().status;  // 400, 413: too deep or too large for a document
  if (status != 422 && status != 400 && status != 413) return kept;
  Dict found{{"valid", false}};
  for (const auto& [key, value] : kept.error().errors) found.set(key, value);
  return found;
}

Outcome change_document(const Context& context, const Dict& arguments) {
  const auto author = author_of(context);
  if (!author) return tl::unexpected(author.error());
  const Value* revision = arguments.find("revision");
  Target target{"documents", text_of(arguments, "name")};
  target.with("author", *author).with("message", arguments.find("note"));
  const HttpClient::Headers condition = {revision ? std::pair{"If-Match", '"' + to_json(*revision) + '"'}
                                                  : std::pair{"If-None-Match", std::string("*")}};
  return without(context.api.ask("PUT", target, *arguments.find("document"), condition), "document");
}

}  // namespace race::server::mcp
