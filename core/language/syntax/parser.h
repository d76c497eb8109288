// The parser: tokens to a syntax tree. Recursive descent, one function for each production. It knows Python's grammar
// beyond the function language, so that it reports `forbidden` for other Python and `syntax` for what is not Python.
#pragma once

#include <string_view>
#include <vector>

#include "core/language/interface/symbols.h"
#include "core/language/syntax/ast.h"
#include "core/language/syntax/lexer.h"

namespace race::language {

struct Parsed {
  Tree tree;
  std::vector<Problem> problems;  // empty: the tree is complete
};

/// Parses `text`: statements for a function, otherwise one expression. Never deeper than kMaxNesting.
Parsed parse(std::string_view text, CodeKind kind);

inline constexpr std::size_t kMaxBytes = 65536;  // of one text; so no run of a Program has more than 65535 parts
inline constexpr int kMaxNesting = 200;          // brackets, unary operators, conditional expressions within each other
inline constexpr int kMaxTreeDepth = 500;        // levels of a syntax tree, long chains of operators included

}  // namespace race::language
