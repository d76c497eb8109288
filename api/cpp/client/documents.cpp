#include "api/cpp/client/documents.h"

#include <limits>
#include <optional>
#include <utility>

#include "api/cpp/client/answer_internal.h"
#include "api/cpp/client/calls.h"

namespace race::client {

std::string tag(std::int64_t revision) { return '"' + std::to_string(revision) + '"'; }

Answered<List> all_documents(const Client& client) {
  List all;
  for (std::optional<std::string> after;;) {
    ASSIGN_OR_RETURN(const Value page, client.send(calls::list_documents({.after = after})));
    ASSIGN_OR_RETURN(const List documents, list_in(page, "documents"));
    all.insert(all.end(), documents.begin(), documents.end());
    const Value* const next = page.find("next");
    if (!next || !next->is_string()) return all;
    after = next->as_string();
  }
}

Answered<List> check_document(const Client& client, const Value& document, std::string_view name) {
  constexpr std::int64_t kNoRevision = std::numeric_limits<std::int32_t>::max();  // a document has at most 100000
  auto stored = client.send(calls::put_document(name, document, {.if_match = tag(kNoRevision)}));
  if (stored) return failure(kProtocol, "the server has stored a document under a condition that does not hold");
  if (stored.error().status == 412) return List();
  if (stored.error().status == 422) return std::move(stored.error().errors);
  return tl::unexpected(std::move(stored.error()));
}

}  // namespace race::client
