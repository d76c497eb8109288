#include "core/rcm/constraints.h"

#include <set>
#include <string_view>

#include "core/rcm/constraints_internal.h"
#include "core/rcm/extent.h"
#include "core/rcm/library.h"

namespace race::rcm {
namespace {

/// The paths of nodes without a name, for which reading has already reported a violation.
std::set<std::string_view> said_nameless(const std::vector<Error>& errors) {
  std::set<std::string_view> out;
  for (const Error& error : errors) {
    if (error.path.ends_with('?')) out.insert(error.path);
  }
  return out;
}

void check_extent(const Document& document, const Library& library, std::vector<Error>& errors) {
  const Extent extent = extent_of(document, library);
  if (extent.depth > kMaxDepth)
    errors.push_back(
        {ErrorCode::too_deep, "states and links are nested more than " + std::to_string(kMaxDepth) + " levels deep"});
  if (extent.states > kMaxStates || extent.bytes > kMaxBytes)
    errors.push_back({ErrorCode::too_large, "with its links, it has more than " + std::to_string(kMaxStates) +
                                                " states and barriers, or more than " +
                                                std::to_string(kMaxBytes >> 20U) + " MiB of text"});
}

}  // namespace

std::vector<Error> violations(const Draft& draft) {
  std::vector<Error> errors = draft.errors;
  const auto nameless = said_nameless(draft.errors);
  const Library library(draft.document);
  std::vector<Error> structure;
  check_structure(draft.document, draft.has_root, library, structure);
  for (Error& error : structure) {
    if (error.code != ErrorCode::name || !nameless.contains(error.path)) errors.push_back(std::move(error));
  }
  if (errors.empty()) check_extent(draft.document, library, errors);
  const bool names = errors.empty();
  check_code(draft.document, library, names, errors);
  return errors;
}

std::vector<Error> violations(const Document& document) { return violations(Draft{document, {}, true}); }

}  // namespace race::rcm
