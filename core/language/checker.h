// The checker: whether a syntax tree is code of the function language and of the state whose names it uses.
#pragma once

#include <vector>

#include "core/language/ast.h"
#include "core/language/code.h"
#include "core/language/lexer.h"

namespace race::language {

/// Every violation of the codes `forbidden`, `scope`, `effect`, `service_call` and `unknown_name`, in the order of the
/// text. Syntax is the parser's.
std::vector<Problem> check(const Tree& tree, CodeKind kind, const Symbols& symbols);

}  // namespace race::language
