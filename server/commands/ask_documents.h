// The documents of a running server, for the commands models, pull and push and for completion (api/openapi.yaml,
// /api/v1/documents).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/commands/ask_server.h"

namespace race::server {

struct DocumentSummary {
  std::string name;
  std::int64_t revision = 0, errors = 0;  // errors: 0: a document, else a draft; 201: more than 200
};

struct DocumentList {
  std::vector<DocumentSummary> documents;  // by name
  List json;                               // the same, as they came (schemas/documents.json)
  List damaged;                            // schemas/errors.json
};

/// All documents and drafts. Otherwise prints why not, and gives the exit code.
tl::expected<DocumentList, int> list_documents(const ServerOptions& server);

/// Names on stderr the documents that are damaged, if any are. Gives the exit code.
int report_damaged(ServerOptions server, const DocumentList& list);

/// Adds a page of the list, which begins after the name `after`. Returns the name after which the next page begins;
/// empty: it was the last one. Error `io`: it is no page, or leads not further.
Expected<std::string> add_page(const Value& page, const std::string& after, DocumentList& list);

struct ServerDocument {
  std::int64_t revision = 0;
  std::string text;  // as a file holds it (document_file.h)
};

/// schemas/document_entry.json. Error `io`: it is none.
Expected<ServerDocument> read_document_entry(const Value& answer);

/// The last revision; nothing: there is none of this name. Otherwise prints why not, and gives the exit code.
tl::expected<std::optional<ServerDocument>, int> get_document(const ServerOptions& server, const std::string& name);

/// The path of a document in requests.
std::string document_path(const std::string& name);

}  // namespace race::server
