// The constraints on documents: of structure (thesis 3.1, after Definitions 3.8 and 3.9; links and oracles, 3.3) and of
// code (3.2, core/SEMANTICS.md section 2). Violations are listed with the path of the state that holds them or,
// for a port, of the port: those of the shape, then of structure, then of code, each in the order of the document,
// until the list is full (error_list.h). Pure functions.
#pragma once

#include <cstddef>
#include <vector>

#include "core/rcm/code_checks.h"
#include "core/rcm/document.h"
#include "core/rcm/model.h"
#include "core/value/expected.h"

namespace race::rcm {

/// How large a native model may become, links expanded; a document beyond it is rejected (`too_large`, `too_deep`).
inline constexpr std::size_t kMaxStates = 100'000;
inline constexpr std::size_t kMaxDepth = 256;
inline constexpr std::size_t kMaxBytes = 64U << 20U;

/// The violations of a document. If its structure has violations, names in its code are not checked (`scope`,
/// `unknown_name`).
std::vector<Error> violations(const Document& document);

/// The same, faster if `checks` comes from the revision before: what was checked then is not checked again.
std::vector<Error> violations(const Document& document, CodeChecks& checks);

/// The same of what could be read of a document, with the errors of reading it.
std::vector<Error> violations(const Draft& draft);

}  // namespace race::rcm
