#include "core/rcm/constraints.h"

#include <algorithm>

#include "core/rcm/constraints_internal.h"
#include "core/rcm/extent.h"
#include "core/rcm/library.h"

namespace race::rcm {
namespace {

/// Whether reading has said already what is wrong with the name of the nameless node at `path`.
bool said(const Draft& draft, const Error& error) {
  if (error.code != ErrorCode::name || !error.path.ends_with('?')) return false;
  return std::any_of(draft.errors.begin(), draft.errors.end(), [&](const Error& e) { return e.path == error.path; });
}

void check_extent(const Document& document, const Library& library, std::vector<Error>& errors) {
  const Extent extent = extent_of(document, library);
  if (extent.depth > kMaxDepth)
    errors.push_back(
        {ErrorCode::too_deep, "states and links are nested more than " + std::to_string(kMaxDepth) + " levels deep"});
  if (extent.states > kMaxStates)
    errors.push_back({ErrorCode::too_large,
                      "with its links, it has more than " + std::to_string(kMaxStates) + " states and barriers"});
}

}  // namespace

std::vector<Error> violations(const Draft& draft) {
  std::vector<Error> errors = draft.errors;
  const Library library(draft.document);
  std::vector<Error> structure;
  check_structure(draft.document, draft.has_root, library, structure);
  for (Error& error : structure) {
    if (!said(draft, error)) errors.push_back(std::move(error));
  }
  if (errors.empty()) check_extent(draft.document, library, errors);
  const bool names = errors.empty();
  check_code(draft.document, library, names, errors);
  return errors;
}

std::vector<Error> violations(const Document& document) { return violations(Draft{document, {}, true}); }

}  // namespace race::rcm
