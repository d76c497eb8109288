#include "server/commands/ask_documents.h"

#include <limits>

#include "core/value/fields.h"
#include "server/commands/command.h"
#include "server/commands/document_file.h"
#include "server/http/encode_part.h"

namespace race::server {
namespace {

constexpr const char* kDocuments = "/api/v1/documents";
constexpr std::int64_t kMany = std::numeric_limits<std::int64_t>::max();

int refuse_at(const ServerOptions& server, const Error& error) {
  return refuse(Error{error.code, error.message, server.url}, server.json);
}

}  // namespace

std::string document_path(const std::string& name) { return kDocuments + ('/' + encode_part(name)); }

Expected<std::string> add_page(const Value& page, const std::string& after, DocumentList& list) {
  std::vector<Error> errors;
  Fields fields(page, "", "the list", errors);
  for (const Value& each : fields.list("documents", kRequired)) {
    Fields of_one(each, "", "the document", errors);
    const auto name = of_one.text("name", kRequired);
    const auto revision = of_one.integer("revision", 0, kMany, kRequired),
               wrong = of_one.integer("errors", 0, kMany, kRequired);
    if (name && revision && wrong) list.documents.push_back({*name, *revision, *wrong});
    list.json.push_back(each);
  }
  for (const Value& each : fields.list("damaged")) list.damaged.push_back(each);
  std::string next = fields.text("next").value_or("");
  if (!errors.empty()) return unexpected(ErrorCode::io, "answers what is no list of documents");
  if (!next.empty() && next <= after) return unexpected(ErrorCode::io, "answers a list of documents without an end");
  return next;
}

tl::expected<DocumentList, int> list_documents(const ServerOptions& server) {
  DocumentList list;
  std::string after;
  do {
    const auto page = ask_server(server, "GET", kDocuments + (after.empty() ? "" : "?after=" + encode_part(after)));
    if (!page) return tl::unexpected(page.error());
    const auto next = add_page(*page, after, list);
    if (!next) return tl::unexpected(refuse_at(server, next.error()));
    after = *next;
  } while (!after.empty());
  return list;
}

int report_damaged(ServerOptions server, const DocumentList& list) {
  if (list.damaged.empty()) return kExitOk;
  server.json = false;  // stdout is for the others
  return refuse_answer(server, {500, Dict{{"errors", list.damaged}}});
}

Expected<ServerDocument> read_document_entry(const Value& answer) {
  std::vector<Error> errors;
  Fields fields(answer, "", "the document", errors);
  const auto revision = fields.integer("revision", 1, kMany, kRequired);
  const Value* document = fields.find("document", kRequired);
  if (!errors.empty() || !document->is_dict()) return unexpected(ErrorCode::io, "answers what is no document");
  return ServerDocument{*revision, document_text(*document)};
}

tl::expected<std::optional<ServerDocument>, int> get_document(const ServerOptions& server, const std::string& name) {
  const auto answer = request_server(server, "GET", document_path(name));
  if (!answer) return tl::unexpected(answer.error());
  if (answer->status == 404) return std::optional<ServerDocument>();
  if (!is_fine(*answer)) return tl::unexpected(refuse_answer(server, *answer, name));
  auto document = read_document_entry(answer->body);
  if (!document) return tl::unexpected(refuse_at(server, document.error()));
  return std::optional(std::move(*document));
}

}  // namespace race::server
