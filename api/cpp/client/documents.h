// What is asked of documents with more than a call: their list, page by page, and their violations.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "api/cpp/client/client.h"

namespace race::client {

/// A revision as the headers If-Match and If-None-Match have it.
std::string tag(std::int64_t revision);

/// Each document by name (documents.json): name, last revision, and how many errors it has. Errors: those of the route.
Answered<List> all_documents(const Client& client);

/// The violations that a document has, as of ApiError::errors; none: it can be stored and run. Nothing is stored: the
/// server checks a document before it looks at the condition under which it would store it, and this asks for one that
/// does not hold. Needs the right to change documents.
Answered<List> check_document(const Client& client, const Value& document, std::string_view name = "check");

}  // namespace race::client
