// The constraints in two parts, used by constraints.cpp alone.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/rcm/code_checks.h"
#include "core/rcm/library.h"
#include "core/rcm/model.h"
#include "core/value/expected.h"

namespace race::rcm {

/// Violations of structure, appended to `errors` until it is full. Without a root that could be read, only the library
/// is checked. `nameless`: paths of nodes of which it is known that they have no name.
void check_structure(const Document& document, bool has_root, const Library& library,
                     const std::set<std::string>& nameless, std::vector<Error>& errors);

/// Violations of code, appended to `errors` until it is full. `names`: whether names are checked, which requires a
/// valid structure. `checks`: of an earlier revision, or nullptr.
void check_code(const Document& document, const Library& library, bool names, CodeChecks* checks,
                std::vector<Error>& errors);

}  // namespace race::rcm
