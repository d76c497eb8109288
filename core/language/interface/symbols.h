// Symbols: the names that code may use, each with its index in Δ; and the three kinds of code.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/language/interface/ids.h"

namespace race::language {

enum class CodeKind : std::uint8_t {
  condition,   // COND: ports and actions, three-valued
  expression,  // EXPR: `from` of a parameter; scope of the parent, no svc, no port
  function,    // CODE: entry, exit, actions
};

/// The names that code of one state may use (SEMANTICS.md section 2, Scopes), each with its index in Δ. The checker
/// uses the names alone.
struct ChildSymbols {
  bool barrier = false;  // a barrier has `active` and `name` only
  Flag active = 0;
  std::map<std::string, ValueIndex, std::less<>> parameters, results;
  std::map<std::string, Flag, std::less<>> ports;
};
struct Symbols {
  std::map<std::string, ValueIndex, std::less<>> parameters, results;
  std::map<std::string, ValueIndex, std::less<>>
      variables;  // declared ones, and for compiling all that any code of the state uses
  std::map<std::string, Flag, std::less<>> ports;
  std::map<std::string, ChildSymbols, std::less<>> children;
};

}  // namespace race::language
