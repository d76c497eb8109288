#include "core/rcm/constraints.h"

#include <set>
#include <string>

#include "core/rcm/constraints_internal.h"
#include "core/rcm/extent.h"
#include "core/rcm/library.h"
#include "core/value/error_list.h"

namespace race::rcm {
namespace {

/// The paths of nodes without a name, for which reading has already reported a violation.
std::set<std::string> said_nameless(const std::vector<Error>& errors) {
  std::set<std::string> out;
  for (const Error& error : errors) {
    if (error.path.ends_with('?')) out.insert(error.path);
  }
  return out;
}

void check_extent(const Document& document, const Library& library, std::vector<Error>& errors) {
  const Extent extent = extent_of(document, library);
  if (extent.depth > kMaxDepth)
    add_error(errors, {ErrorCode::too_deep,
                       "states and links are nested more than " + std::to_string(kMaxDepth) + " levels deep"});
  if (extent.states > kMaxStates || extent.bytes > kMaxBytes)
    add_error(errors, {ErrorCode::too_large, "with its links, it has more than " + std::to_string(kMaxStates) +
                                                 " states and barriers, or more than " +
                                                 std::to_string(kMaxBytes >> 20U) + " MiB of text"});
}

/// Appends what is wrong with a document to what reading it has found.
void add_violations(const Document& document, bool has_root, CodeChecks* checks, std::vector<Error>& errors) {
  if (is_full(errors)) return;
  const auto nameless = said_nameless(errors);
  const Library library(document);
  check_structure(document, has_root, library, nameless, errors);
  if (errors.empty()) check_extent(document, library, errors);
  const bool names = errors.empty();
  check_code(document, library, names, checks, errors);
}

}  // namespace

std::vector<Error> violations(const Draft& draft) {
  std::vector<Error> errors = draft.errors;
  add_violations(draft.document, draft.has_root, nullptr, errors);
  return errors;
}

std::vector<Error> violations(const Document& document) {
  std::vector<Error> errors;
  add_violations(document, true, nullptr, errors);
  return errors;
}

std::vector<Error> violations(const Document& document, CodeChecks& checks) {
  std::vector<Error> errors;
  add_violations(document, true, &checks, errors);
  return errors;
}

}  // namespace race::rcm
