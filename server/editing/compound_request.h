// Compound edits as clients ask for them (schemas/edit_request.json): which one, with which arguments. Pure.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/edit/operation.h"
#include "core/edit/tree.h"
#include "core/value/expected.h"

namespace race::server {

struct CompoundRequest {
  std::string kind;                                           // "rename"
  std::map<std::string, std::string, std::less<>> arguments;  // those that are texts, by the names of compound.h
  edit::Ids ids;                                              // of `group`
};

/// Adds violations, with paths such as `compound/id`, to `errors`.
CompoundRequest read_compound(const Value& json, std::vector<Error>& errors);

/// The edit of `tree` (core/edit/compound.h). `seed`: of new ids; differs from one edit to the next. Errors: those of
/// compound.h. Requires a request that was read without violations.
Expected<edit::Edit> make_edit(const CompoundRequest& request, const edit::Tree& tree, std::string_view seed);

}  // namespace race::server
